// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "image_file.h"
#include "nacre/spectral/spectrum_files.h"

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
    const std::string& file, const std::vector<Pixel>& pixels = {});

/// The same for a file that exists, the key of a spectrum in the library, or an illuminant.
[[nodiscard]] std::vector<spectral::NamedSpectrum> read_spectra_input(const std::string& input);

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
