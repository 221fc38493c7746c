// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/image_file.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"

/// @file
/// Spectra from whatever a user names: files of text, images, keys, lights.

namespace nacre::tool {

/// A file whose name ends as that of an image or FTXT does.
[[nodiscard]] bool is_texture_file(const std::string& file);

/// Column and row, from 0 at the top left.
struct Pixel {
    std::size_t x, y;
};

/// All spectra of a file of text (nacre/spectral/spectrum_files.h) or of an image that
/// spectra_of_image() can read.
/// @param pixels  of a spectral image, only those
/// @throws InputError with all that is wrong
[[nodiscard]] std::vector<spectral::NamedSpectrum> read_spectra_file(
    const std::string& file, const std::vector<Pixel>& pixels = {},
    const spectral::ReadAs& said = {});

/// Of --kind, which may be empty, and --scale. @throws InputError for a scale that is not > 0
[[nodiscard]] spectral::ReadAs read_as(const std::string& kind, std::optional<double> scale);

inline constexpr const char* kScaleHelp =
    "multiplies the values of files: 0.01 for per cent, 1 for ratios above 1";

/// That --kind took the place of what `input` states; nothing where it did not.
[[nodiscard]] std::optional<std::string> override_note(
    const std::string& input, const std::vector<spectral::NamedSpectrum>& spectra);

/// The same for a file that exists, the key of a spectrum in the library, or an illuminant.
/// @param said  the scale is of files alone
[[nodiscard]] std::vector<spectral::NamedSpectrum> read_spectra_input(
    const std::string& input, const spectral::ReadAs& said = {});

/// What nacre bake cmf, spectra and material wrote, as spectra; those of a spectral EXR, one a
/// pixel; and of an RGBA image of packed spectra by somebody else, whose width tells.
/// @param file    what to call the image in messages
/// @param pixels  of a spectral image, only those
[[nodiscard]] std::vector<spectral::NamedSpectrum> spectra_of_image(
    const LoadedImage& loaded, const std::string& file, const std::vector<Pixel>& pixels = {});

/// One spectrum over wavelengths in equal steps.
[[nodiscard]] spectral::NamedSpectrum named_spectrum(std::string name, double first_nm,
                                                     std::vector<double> values,
                                                     std::optional<spectral::SpectrumKind> kind);

}  // namespace nacre::tool
