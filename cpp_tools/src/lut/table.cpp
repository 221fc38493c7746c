// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/table.h"

#include <algorithm>
#include <cmath>

namespace nacre::lut {

double rounded_texel(double value, int bits) noexcept
{
    constexpr int kLeastExponent = -5;
    int exponent = 0;
    std::frexp(value, &exponent);  // |value| < 2^exponent
    const double step = std::ldexp(1.0, std::max(exponent - 1, kLeastExponent) - bits);
    return std::nearbyint(value / step) * step;
}

double Axis::at(int texel) const noexcept
{
    if (texels < 2) return min;
    if (texel == texels - 1) return max;  // exact, whatever the step rounds to
    return min + (max - min) * texel / (texels - 1);
}

}  // namespace nacre::lut
