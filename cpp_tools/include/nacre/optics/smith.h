// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

/// @file
/// Smith's shadowing and masking of GGX microfacets (Walter et al. 2007).

namespace nacre::optics {

/// Smith's Λ: the masked share of a direction is Λ/(1 + Λ).
[[nodiscard]] inline double smith_lambda(double cos_theta, double alpha) noexcept
{
    const double squared = std::max(cos_theta * cos_theta, 1e-12);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - squared) / squared) - 1.0);
}

}  // namespace nacre::optics
