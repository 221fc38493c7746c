// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "files/image_file.h"
#include "nacre/spectral/colour.h"

namespace nacre::tool {

/// How far two images of one size are apart. Pixels where either has a NaN or an infinity are
/// counted and left out of the figures; in `delta_e` they are NaN.
struct ImageDifference {
    std::vector<float> delta_e;  ///< CIEDE2000 of each pixel, (1, 1, 1) of the space as white
    double mean = 0.0, max = 0.0, rmse = 0.0;
    int worst_x = 0, worst_y = 0;
    std::int64_t not_finite = 0;
};

/// The first three colour channels (R, G, B by name where they are there, else the first three, or
/// one for all) as scene-linear values.
[[nodiscard]] std::vector<spectral::Vec3> linear_pixels(const LoadedImage& loaded);

/// @pre both have `width` × n pixels
[[nodiscard]] ImageDifference compare_pixels(const std::vector<spectral::Vec3>& a,
                                             const std::vector<spectral::Vec3>& b, int width,
                                             const spectral::ColourSpace& space);

}  // namespace nacre::tool
