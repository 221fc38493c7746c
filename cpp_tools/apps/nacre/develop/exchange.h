// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "develop/spectral_picture.h"

/// @file
/// Other lamps in a picture that is rendered.

namespace nacre::tool {

/// What a pixel's channels are multiplied by, band by band, before all is summed: (1 … of the
/// whole, and of each light group what it becomes less what it is in the whole already).
struct Mixture {
    struct Part {
        const Layer* layer;
        std::vector<double> factors;
    };
    std::vector<Part> parts;

    [[nodiscard]] std::vector<double> radiance(const SpectralPicture& picture,
                                               const float* pixel) const;
};

/// @param lights     `LIGHT` for what lights all of the picture, or `GROUP=LIGHT`; as bright as the
///                   one before
/// @param strengths  `GROUP=FACTOR`
/// @throws InputError for a group that is not there, or a light that is not known or cannot be
///         exchanged
[[nodiscard]] Mixture mixture(const SpectralPicture& picture,
                              const std::vector<std::string>& lights,
                              const std::vector<std::string>& strengths);

}  // namespace nacre::tool
