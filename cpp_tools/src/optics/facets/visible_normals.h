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

/// GGX facets as a view sees them, from two numbers in [0, 1): facets of a stretched surface are
/// those of a half-sphere, which mirror the view evenly over a cap (Dupuy and Benyoub 2023). The
/// view may come from below, as light does that rises between facets.
class VisibleNormals {
public:
    /// Around the axis that the cap has: where the half vector is before the view is added.
    struct Height {
        double z, across;
    };
    struct Direction {
        double cos, sin;
    };

    VisibleNormals(const Vector& view, const std::array<double, 2>& alpha) noexcept
        : alpha_(alpha), stretched_(normalised({alpha[0] * view[0], alpha[1] * view[1], view[2]}))
    {}

    [[nodiscard]] Height height(double v) const noexcept
    {
        const double z = (1.0 - v) * (1.0 + stretched_[2]) - stretched_[2];
        return {z, std::sqrt(std::max(0.0, 1.0 - z * z))};
    }
    [[nodiscard]] static Direction direction(double u) noexcept
    {
        const double azimuth = 2.0 * std::numbers::pi * u;
        return {std::cos(azimuth), std::sin(azimuth)};
    }
    [[nodiscard]] Vector at(const Direction& to, const Height& at) const noexcept
    {
        const Vector half{at.across * to.cos + stretched_[0], at.across * to.sin + stretched_[1],
                          at.z + stretched_[2]};
        return normalised({alpha_[0] * half[0], alpha_[1] * half[1], std::max(half[2], 1e-12)});
    }

private:
    std::array<double, 2> alpha_;
    Vector stretched_;
};

inline Vector visible_normal(const Vector& view, const std::array<double, 2>& alpha, double u,
                             double v) noexcept
{
    const VisibleNormals normals(view, alpha);
    return normals.at(VisibleNormals::direction(u), normals.height(v));
}

}  // namespace nacre::optics
