// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

/// @file
/// Rough surfaces of GGX microfacets (Walter et al. 2007) with Smith's shadowing and masking,
/// correlated in height (Heitz 2014, JCGT 3(2)): what a view from one side sees of the facets, and
/// how much of the light leaves after one bounce. Isotropic; the surface lies across z, and
/// cos_theta is that of the view, in [0, 1]. 0 is taken as a grazing 1e-4.

namespace nacre::optics {

/// How often a view meets the facets at each angle, over the facets that it sees and whose mirrored
/// light gets out: the mean of a reflectance R over the rough surface is Σ weights[i] R(c_i) for a
/// reflectance that is linear in the facet's cosine between the steps c_i = i/(n − 1), n the size.
/// @pre at least 2 weights; alpha in (0, 1]
/// @return the directional albedo of perfect mirrors, 1 bounce: what shadowing leaves of 1
double facet_weights(double cos_theta, double alpha, std::span<double> weights);

/// The directional albedo alone.
[[nodiscard]] double ggx_albedo(double cos_theta, double alpha);

}  // namespace nacre::optics
