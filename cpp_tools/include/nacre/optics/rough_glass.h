// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

/// @file
/// The rough border of clear glass, GGX facets as in microfacet.h: what is seen of it from either
/// side, and how much of the light leaves after one bounce by reflection and by refraction (Walter
/// et al. 2007).

namespace nacre::optics {

struct GlassView {
    double cos_theta;     ///< in the medium that the view is in; 0 is taken as a grazing 1e-4
    double alpha;         ///< in [0, 1]; 0 is smooth
    double index;         ///< of the glass, relative to the ambient
    bool inside = false;  ///< the view is in the glass
};

/// How often the view meets the facets at each angle, as facet_weights() has it: over the cosine
/// c_i = i/(n − 1) in the ambient, which refraction ties to the one in the glass; facets that
/// reflect totally are at 0. A film has the same R and T from both sides at such angles.
struct GlassFacets {
    std::vector<double> met;        ///< sums to 1
    std::vector<double> reflected;  ///< of these the share whose mirrored light gets out
    std::vector<double> passed;     ///< of these the share whose refracted light gets out
    /// Sums of both: albedos of a lobe of facets that all reflect, or all pass what is not totally
    /// reflected.
    double mirror = 0.0, window = 0.0;
    /// The same of bare facets, which reflect F and pass 1 − F.
    double clear_mirror = 0.0, clear_window = 0.0;
};

/// @param columns  of each of the weights, at least 2
[[nodiscard]] GlassFacets glass_facets(const GlassView& view, std::size_t columns);

}  // namespace nacre::optics
