// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

#include "index_rows.h"
#include "medium_yaml.h"
#include "nacre/core/diagnostics.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"

namespace nacre::spectral {

namespace {

/// One of the two files.
struct Part {
    std::string_view text, file;
    bool is_n;
};

/// k below 0 by no more than noise is 0.
Spectrum without_noise(const Spectrum& k, const std::string& file,
                       std::vector<std::string>& changes)
{
    std::vector<double> values = k.values();
    std::size_t count = 0;
    for (double& value : values)
        if (value < 0.0 && value >= kLeastNoiseOfK) {
            value = 0.0;
            ++count;
        }
    if (count > 0)
        changes.push_back(
            fmt::format("{}: k < 0 taken as 0 ({} {})", file, count, count == 1 ? "row" : "rows"));
    return {k.wavelengths_nm(), std::move(values)};
}

/// What was read; problems of either file are added to `problems`.
std::optional<Spectrum> read_part(const Part& part, DiagnosticList& problems,
                                  std::vector<std::string>& changes)
{
    const std::string file(part.file);
    try {
        Spectrum samples = std::move(read_spd(part.text, part.file).front().samples);
        if (!part.is_n) samples = without_noise(samples, file, changes);
        for (std::size_t i = 0; i < samples.values().size(); ++i) {
            const double value = samples.values()[i];
            if (part.is_n ? value > 0.0 : value >= 0.0) continue;
            problems.add({file, 0, part.is_n ? "n" : "k",
                          fmt::format("must be {} 0 (got {:g} at {:g} nm)", part.is_n ? ">" : "≥",
                                      value, samples.wavelengths_nm()[i])});
            break;  // one is enough: most likely all are of another kind
        }
        return samples;
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        return std::nullopt;
    }
}

/// The wavelengths of both within the range that they share.
std::vector<double> common_wavelengths(const Spectrum& n, const Spectrum& k)
{
    std::vector<double> all;
    std::ranges::set_union(n.wavelengths_nm(), k.wavelengths_nm(), std::back_inserter(all));
    const double first = std::max(n.first_nm(), k.first_nm());
    const double last = std::min(n.last_nm(), k.last_nm());
    std::erase_if(all, [=](double nm) { return nm < first || nm > last; });
    return all;
}

}  // namespace

std::string refractiveindex_yaml_from_spd(std::string_view n_text, std::string_view n_name,
                                          std::string_view k_text, std::string_view k_name,
                                          std::string_view references,
                                          std::vector<std::string>& changes)
{
    DiagnosticList problems;
    std::vector<std::string> mended;
    const auto n = read_part({n_text, n_name, true}, problems, mended);
    const auto k = read_part({k_text, k_name, false}, problems, mended);
    problems.throw_if_any();
    const std::vector<double> wavelengths = common_wavelengths(*n, *k);
    if (wavelengths.size() < 2)
        throw InputError(
            {std::string(k_name), 0, "wavelength",
             fmt::format("must overlap {:g} … {:g} nm of {} (got {:g} … {:g})", n->first_nm(),
                         n->last_nm(), n_name, k->first_nm(), k->last_nm())});
    changes.insert(changes.end(), mended.begin(), mended.end());
    return medium_yaml({.name = {},
                        .references = std::string(references),
                        .comments = changes_text(mended),
                        .wavelengths_nm = wavelengths,
                        .n = n->values_at(wavelengths, Interpolation::linear),
                        .k = k->values_at(wavelengths, Interpolation::linear),
                        .has_k = true});
}

}  // namespace nacre::spectral
