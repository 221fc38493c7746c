// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace nacre::optics {

/// sin(x)/x
inline double sinc(double x) noexcept
{
    return x == 0.0 ? 1.0 : std::sin(x) / x;
}

}  // namespace nacre::optics
