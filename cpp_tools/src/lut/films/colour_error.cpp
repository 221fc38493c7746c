// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "films/colour_error.h"

namespace nacre::lut {

double ColourError::operator()(const spectral::Vec3& a, const spectral::Vec3& b) const noexcept
{
    const auto lab = [this](const spectral::Vec3& colour) {
        spectral::Vec3 xyz{};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                xyz[row] += to_xyz_[row][column] * colour[column];
        return spectral::xyz_to_lab(xyz, spectral::d65_white());
    };
    return spectral::delta_e_2000(lab(a), lab(b));
}

}  // namespace nacre::lut
