// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_slices.h"

namespace nacre::lut {

double slice_share(double slice, int low) noexcept
{
    const auto alpha_squared = [](double at) { return at * at * at * at; };
    return (alpha_squared(slice) - alpha_squared(low)) /
           (alpha_squared(low + 1.0) - alpha_squared(low));
}

}  // namespace nacre::lut
