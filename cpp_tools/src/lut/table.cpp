// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/table.h"

namespace nacre::lut {

double Axis::at(int texel) const noexcept
{
    if (texels < 2) return min;
    if (texel == texels - 1) return max;  // exact, whatever the step rounds to
    return min + (max - min) * texel / (texels - 1);
}

}  // namespace nacre::lut
