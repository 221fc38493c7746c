// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "text_lines.h"

namespace nacre::spectral {

std::string_view spectrum_kind_name(SpectrumKind kind) noexcept
{
    return kind == SpectrumKind::emission ? "emission" : "reflectance";
}

namespace {

Interpolation interpolation_of(const NamedSpectrum& spectrum)
{
    return spectrum.kind == SpectrumKind::emission ? Interpolation::linear
                                                   : spectrum.samples.recommended();
}

}  // namespace

Sampled NamedSpectrum::on_grid() const
{
    return samples.on_grid(interpolation_of(*this));
}

std::vector<double> NamedSpectrum::values_at(std::span<const double> wavelengths_nm) const
{
    return samples.values_at(wavelengths_nm, interpolation_of(*this));
}

std::optional<std::string> kind_problem(const Spectrum& samples, SpectrumKind kind)
{
    const auto [lowest, highest] = std::ranges::minmax(samples.values());
    if (kind == SpectrumKind::reflectance) {
        constexpr double kMost = 2.0;
        if (lowest >= 0.0 && lowest <= 1.0 && highest <= kMost) return std::nullopt;
        // What fluoresces takes its light from other wavelengths.
        if (lowest > 1.0 && highest <= kMost)
            return fmt::format(
                "a reflectance must be ≤ 1 somewhere, 1 for all of the light (got {:g} … {:g})",
                lowest, highest);
        return fmt::format(
            "a reflectance must be in [0, {:g}], 1 for all of the light (got {:g} … {:g})", kMost,
            lowest, highest);
    }
    if (lowest < 0.0) return fmt::format("an emission must be ≥ 0 (got {:g})", lowest);
    if (highest == 0.0) return "an emission must be > 0 somewhere";
    return std::nullopt;
}

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
