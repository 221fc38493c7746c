// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/spectrum_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/library/lights.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/illuminant.h"

namespace nacre::tool {

using spectral::NamedSpectrum;
using spectral::SpectrumKind;

NamedSpectrum named_spectrum(std::string name, double first_nm, std::vector<double> values,
                             std::optional<SpectrumKind> kind)
{
    std::vector<double> wavelengths(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        wavelengths[i] = first_nm + static_cast<double>(i);
    return {.key = {},
            .name = std::move(name),
            .references = {},
            .licence = {},
            .comments = {},
            .tags = {},
            .kind = kind,
            .samples = {std::move(wavelengths), std::move(values)},
            .unit_stated = true};
}

spectral::ReadAs read_as(const std::string& kind, std::optional<double> scale)
{
    if (scale && !(std::isfinite(*scale) && *scale > 0.0))
        throw InputError(
            {{}, 0, "--scale", fmt::format("must be finite and > 0 (got {:g})", *scale)});
    spectral::ReadAs said{.kind = {}, .scale = scale};
    for (const SpectrumKind known : {SpectrumKind::emission, SpectrumKind::reflectance})
        if (kind == spectrum_kind_name(known)) said.kind = known;
    return said;
}

bool is_texture_file(const std::string& file)
{
    constexpr std::array<std::string_view, 4> kExtensions = {".exr", ".tx", ".png", ".ftxt"};
    const std::string extension = std::filesystem::path(file).extension().string();
    return std::ranges::find(kExtensions, extension) != kExtensions.end();
}

std::vector<NamedSpectrum> read_spectra_file(const std::string& file,
                                             const std::vector<Pixel>& pixels,
                                             const spectral::ReadAs& said)
{
    if (is_texture_file(file)) {
        auto spectra = spectra_of_image(read_image(file, AlphaMeaning::number), file, pixels);
        apply(said, spectra, file);
        return spectra;
    }
    if (!pixels.empty()) throw InputError({file, 0, "--pixel", "belongs to a spectral image"});
    return spectral::read_spectra(read_text(file), file, said);
}

std::optional<std::string> override_note(const std::string& input,
                                         const std::vector<NamedSpectrum>& spectra)
{
    const auto count = std::ranges::count_if(
        spectra, [](const NamedSpectrum& spectrum) { return spectrum.overridden.has_value(); });
    if (count == 0) return std::nullopt;
    const auto& first = *std::ranges::find_if(
        spectra, [](const NamedSpectrum& spectrum) { return spectrum.overridden.has_value(); });
    const auto of = static_cast<std::size_t>(count) == spectra.size()
                        ? std::string()
                        : fmt::format(" of {} spectra in {}", count, spectra.size());
    return fmt::format("{}: --kind {} in place of the kind {}, which it states{}", input,
                       spectrum_kind_name(*first.kind), spectrum_kind_name(*first.overridden), of);
}

namespace {

bool has_key(const std::string& key)
{
    const auto keys = spectral::library_spectrum_keys();
    return std::ranges::binary_search(keys, key);
}

/// @throws InputError that says what else an input may be
NamedSpectrum light_of(const std::string& input)
{
    try {
        return spectral::light_spectrum(input);
    } catch (const InputError& error) {
        throw InputError({input, 0, "INPUT",
                          fmt::format("must be a file, the key of a spectrum (nacre library list) "
                                      "or an illuminant; as one it {}",
                                      error.diagnostics().front().message)});
    }
}

/// Of the library or a light, whose values are what they are stated to be.
std::vector<NamedSpectrum> known_spectrum(NamedSpectrum spectrum, const std::string& input,
                                          const spectral::ReadAs& said)
{
    spectrum.unit_stated = true;
    std::vector<NamedSpectrum> one{std::move(spectrum)};
    apply({.kind = said.kind, .scale = {}}, one, input);
    return one;
}

}  // namespace

std::vector<NamedSpectrum> read_spectra_input(const std::string& input,
                                              const spectral::ReadAs& said)
{
    if (std::filesystem::is_regular_file(input)) {
        std::vector<NamedSpectrum> spectra = read_spectra_file(input, {}, said);
        for (std::size_t i = 0; i < spectra.size(); ++i)
            if (spectra[i].name.empty())
                spectra[i].name = fmt::format("{}{}", std::filesystem::path(input).stem().string(),
                                              spectra.size() > 1 ? fmt::format(" {}", i + 1) : "");
        return spectra;
    }
    if (has_key(input)) return known_spectrum(spectral::library_spectrum(input), input, said);
    // What looks like a key gets the message that knows near ones.
    if (is_texture_file(input)) (void)read_text(input);
    const bool like_key = input.find('/') != std::string::npos;
    if (like_key && input.find('.') == std::string::npos)
        return {spectral::library_spectrum(input)};
    return known_spectrum(light_of(input), input, said);
}

}  // namespace nacre::tool
