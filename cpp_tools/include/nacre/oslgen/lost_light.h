// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

/// @file
/// How much light rough surfaces send from one facet to others.

namespace nacre::oslgen {

/// What white facets of GGX lose to others in one bounce, over what they do not: where E leaves,
/// ln((1 − E)/E) ≈ Σ c[i][j] ln(α)^i ln(cosθ)^j for α and cosθ from the limits below to 1. A fit of
/// ours to optics::facet_weights(); E is met within 0.014.
inline constexpr std::array<std::array<double, 3>, 4> kLostLight{{
    {0.8205, 0.9092, 0.0295},
    {2.3530, 1.0324, 0.2938},
    {0.2265, -0.2992, -0.0094},
    {0.1201, -0.0449, -0.0113},
}};
inline constexpr double kLeastLostAlpha = 0.03, kLeastLostCosine = 0.05;

}  // namespace nacre::oslgen
