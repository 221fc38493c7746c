// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/lights.h"

#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nacre/core/diagnostics.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::spectral {

namespace {

[[noreturn]] void throw_problem(std::string message)
{
    throw InputError({.file = {}, .field = "illuminant", .message = std::move(message)});
}

/// The whole of `text` as a number.
double number(std::string_view text, std::string_view what)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw_problem(fmt::format("must have a number as {} (got '{}')", what, text));
    return value;
}

SpectralLine parse_line(std::string_view text)
{
    const std::size_t at = text.find('@');
    SpectralLine line{.wavelength_nm = number(text.substr(0, at), "wavelength"), .power = 1.0};
    if (at != std::string_view::npos) line.power = number(text.substr(at + 1), "power");
    return line;
}

std::vector<SpectralLine> parse_lines(std::string_view text)
{
    std::vector<SpectralLine> lines;
    for (;;) {
        const std::size_t comma = text.find(',');
        lines.push_back(parse_line(text.substr(0, comma)));
        if (comma == std::string_view::npos) return lines;
        text.remove_prefix(comma + 1);
    }
}

/// A light of the library of spectra. Its name always has a slash, which no other name has.
const NamedSpectrum& library_light(std::string_view key)
{
    const NamedSpectrum& found = library_spectrum(key);
    if (found.kind != SpectrumKind::emission)
        throw_problem(fmt::format("must be a light; {} is a reflectance", key));
    return found;
}

/// @throws InputError for what is neither of the illuminants with tables nor of their forms
Spectrum samples_of_name(std::string_view name)
{
    if (auto samples = illuminant_samples(name)) return *std::move(samples);
    if (const auto lines = named_lines(name); !lines.empty()) return line_samples(lines);
    const std::size_t colon = name.find(':');
    if (colon != std::string_view::npos) {
        const std::string_view kind = name.substr(0, colon), value = name.substr(colon + 1);
        if (kind == "blackbody") return blackbody_samples(number(value, "temperature in K"));
        if (kind == "daylight") return daylight_samples(number(value, "temperature in K"));
    }
    throw_problem(fmt::format("must be one of {}, {} (got '{}')",
                              fmt::join(illuminant_names(), ", "), kIlluminantForms, name));
}

}  // namespace

NamedSpectrum light_spectrum(std::string_view text)
{
    if (text.find('/') != std::string_view::npos) return library_light(text);
    return {.key = std::string(text),
            .name = std::string(text),
            .references = {},
            .licence = {},
            .comments = {},
            .tags = {},
            .kind = SpectrumKind::emission,
            .samples = samples_of_name(text)};
}

std::vector<SpectralLine> named_lines(std::string_view text)
{
    constexpr std::string_view kForm = "line:";
    if (!text.starts_with(kForm)) return {};
    std::vector<SpectralLine> lines = parse_lines(text.substr(kForm.size()));
    [[maybe_unused]] const Spectrum refuses_lines_off_the_grid = line_samples(lines);
    return lines;
}

Illuminant named_illuminant(std::string_view text)
{
    return {.name = std::string(text), .power = light_spectrum(text).on_grid()};
}

}  // namespace nacre::spectral
