// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "files/image_file.h"
#include "nacre/bands/bands.h"

/// @file
/// A picture with a channel for each band.

namespace nacre::tool {

/// Light of some of the lamps, or all of it: where in a pixel its bands are, in the order of bands.
struct Layer {
    std::string name;  ///< of a light group; empty: everything together
    std::vector<std::size_t> channels;
    std::string light;          ///< what its lamps are, where they are one; else empty
    std::vector<double> power;  ///< of that light in each band, with Y = 1; else empty
};

struct SpectralPicture {
    std::string file;
    Image image;
    bands::Bands bands;
    std::vector<Layer> layers;  ///< the first is the whole

    [[nodiscard]] const float* pixel(std::size_t x, std::size_t y) const noexcept
    {
        const auto width = static_cast<std::size_t>(image.width);
        return image.pixels.data() + (y * width + x) * image.channel_count();
    }
};

/// Channels are named as in A. Fichet, R. Pacanowski, A. Wilkie, "An OpenEXR Layout for Spectral
/// Images", JCGT 10(3), 2021: `S0.589,294nm`, those of a light group after its name and a point.
/// Where bands lie is said by `nacre:bands`; of pictures of other programs they meet half way
/// between wavelengths. `nacre:lights` says what lamps are.
/// @throws InputError for a picture without such channels, or with some that are missing or not
///         those that it speaks of
[[nodiscard]] SpectralPicture read_spectral_picture(const std::string& file);

}  // namespace nacre::tool
