// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "math/vector.h"

namespace nacre::optics {

inline Vector normalised(const Vector& v) noexcept
{
    const double scale = 1.0 / std::sqrt(dot(v, v));
    return {scale * v[0], scale * v[1], scale * v[2]};
}

/// A GGX facet as `view` sees it, from two numbers in [0, 1): facets of a stretched surface are
/// those of a half-sphere, which mirror the view evenly over a cap (Dupuy and Benyoub 2023). The
/// view may come from below, as light does that rises between facets.
inline Vector visible_normal(const Vector& view, const std::array<double, 2>& alpha, double u,
                             double v) noexcept
{
    const Vector stretched = normalised({alpha[0] * view[0], alpha[1] * view[1], view[2]});
    const double z = (1.0 - v) * (1.0 + stretched[2]) - stretched[2];
    const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double azimuth = 2.0 * std::numbers::pi * u;
    const Vector half{across * std::cos(azimuth) + stretched[0],
                      across * std::sin(azimuth) + stretched[1], z + stretched[2]};
    return normalised({alpha[0] * half[0], alpha[1] * half[1], std::max(half[2], 1e-12)});
}

}  // namespace nacre::optics
