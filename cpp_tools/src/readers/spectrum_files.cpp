// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "nacre/core/text_lines.h"

namespace nacre::spectral {

namespace {

/// What may be per cent although nobody says so; nothing for what cannot.
std::optional<std::string> unit_problem(const NamedSpectrum& spectrum)
{
    if (spectrum.unit_stated || spectrum.kind != SpectrumKind::reflectance) return std::nullopt;
    const auto [lowest, highest] = std::ranges::minmax(spectrum.samples.values());
    if (highest <= 1.0) return std::nullopt;
    return fmt::format(
        "must be ratios or per cent, and the file does not say which (got {:g} … {:g}): give a "
        "scale, 0.01 for per cent, 1 for ratios above 1 (--scale of nacre library import, scale= "
        "in Python)",
        lowest, highest);
}

/// Why values that are stated to be of one kind cannot be of the other.
std::optional<std::string> override_problem(const NamedSpectrum& spectrum)
{
    if (!spectrum.overridden) return std::nullopt;
    auto problem = kind_problem(spectrum.samples, *spectrum.kind);
    if (!problem) return std::nullopt;
    return fmt::format("is stated to be of the kind {} and cannot be of the kind {}: {}",
                       spectrum_kind_name(*spectrum.overridden), spectrum_kind_name(*spectrum.kind),
                       *problem);
}

}  // namespace

void apply(const ReadAs& said, std::vector<NamedSpectrum>& spectra, const std::string& file)
{
    FileProblems problems(file);
    for (NamedSpectrum& spectrum : spectra) {
        if (said.kind && spectrum.kind && spectrum.kind != said.kind)
            spectrum.overridden = spectrum.kind;
        if (said.kind) spectrum.kind = said.kind;
        if (said.scale) {
            std::vector<double> values = spectrum.samples.values();
            for (double& value : values) value *= *said.scale;
            spectrum.samples = {spectrum.samples.wavelengths_nm(), std::move(values)};
            spectrum.unit_stated = true;
        }
        auto problem = override_problem(spectrum);
        if (!problem) problem = unit_problem(spectrum);
        if (problem)
            problems.add(0, spectrum.name.empty() ? "values" : spectrum.name, std::move(*problem));
    }
    problems.throw_if_any();
}

SpectrumFormat spectrum_format(std::string_view text, std::string_view file)
{
    constexpr std::array<std::pair<std::string_view, SpectrumFormat>, 6> kExtensions = {{
        {".csv", SpectrumFormat::csv},
        {".spd", SpectrumFormat::spd},
        {".spdx", SpectrumFormat::spdx},
        {".cgats", SpectrumFormat::cgats},
        {".ti3", SpectrumFormat::cgats},
        {".sp", SpectrumFormat::cgats},
    }};
    for (const auto& [extension, format] : kExtensions)
        if (file.ends_with(extension)) return format;
    if (text.find("BEGIN_DATA_FORMAT") != std::string_view::npos) return SpectrumFormat::cgats;
    TextLines lines(text);
    while (const auto line = lines.next()) {
        const std::string_view content = trimmed(*line);
        if (content.empty() || content.front() == '#') continue;
        if (content.front() == '<') return SpectrumFormat::spdx;
        // Two numbers with nothing but space between them.
        const auto words = split_words(content);
        const bool separated = content.find_first_of(",;\t") != std::string_view::npos;
        if (!separated && words.size() == 2 && parse_number(words.front()))
            return SpectrumFormat::spd;
        break;
    }
    return SpectrumFormat::csv;
}

namespace {

std::vector<NamedSpectrum> read_format(std::string_view text, std::string_view file)
{
    switch (spectrum_format(text, file)) {
        case SpectrumFormat::spd:
            return read_spd(text, file);
        case SpectrumFormat::spdx:
            return read_spdx(text, file);
        case SpectrumFormat::cgats:
            return read_cgats(text, file);
        case SpectrumFormat::csv:
            break;
    }
    return read_csv_spectra(text, file);
}

}  // namespace

std::vector<NamedSpectrum> read_spectra(std::string_view text, std::string_view file,
                                        const ReadAs& said)
{
    check_size(text, std::string(file));
    const std::string decoded = utf8_of_utf16(text);
    std::vector<NamedSpectrum> spectra = read_format(decoded.empty() ? text : decoded, file);
    apply(said, spectra, std::string(file));
    return spectra;
}

}  // namespace nacre::spectral
