// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>

/// @file
/// Light among GGX microfacets, bounce by bounce, with nothing left out but what the Smith model
/// itself neglects: the truth that lobes and tables are measured against.

namespace nacre::optics {

struct MicrosurfaceWalk {
    std::array<double, 3> view;   ///< unit, away from the surface, z > 0
    std::array<double, 2> alpha;  ///< along x and y, > 0
    std::uint64_t paths, seed = 1;
    int max_bounces = 16;  ///< a path that is still inside then is left out
};

/// Follows paths from the view down to the facets and out again by reflection (Heitz et al. 2016,
/// "Multiple-scattering microfacet BSDFs with the Smith model", uniform heights). Calls `left` for
/// each path that leaves, with the cosines at the facets it met and the direction it took: a path's
/// share of the light is the product of the reflectances at those cosines, and the mean over all
/// paths is the directional albedo. With one cosine it is what a single-scattering lobe sends.
void walk_microsurface(const MicrosurfaceWalk& walk,
                       const std::function<void(std::span<const double> cosines,
                                                const std::array<double, 3>& out)>& left);

}  // namespace nacre::optics
