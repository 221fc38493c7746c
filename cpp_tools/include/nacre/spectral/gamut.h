// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "nacre/spectral/colour.h"

/// @file
/// Colours outside the gamut of an RGB space: a negative channel, or of a surface one above 1. A
/// light may be as bright as it is.

namespace nacre::spectral {

enum class GamutMapping {
    keep,        ///< as they are
    clip,        ///< each channel into [0, 1] by itself: hue and luminance shift
    desaturate,  ///< towards the grey of the same luminance, just as far as needed; of a light
                 ///< towards the white light of the same luminance, until no channel is negative
    scale,       ///< brighter than 1: all channels by one factor; negative ones become 0 before
};

/// "keep", "clip", "desaturate" or "scale". @throws InputError for any other name.
[[nodiscard]] GamutMapping gamut_mapping_from_name(std::string_view name);

enum class ColourOf {
    surface,  ///< reflectance or transmittance, at most white
    light,    ///< emission
};

/// @param luminance  Y of the three primaries: row 1 of the space's `to_xyz_d65`, of sum 1. Only
///                   `desaturate` reads it, and tells lights: what has no Y > 0 is black, a surface
///                   of Y ≥ 1 white.
[[nodiscard]] Vec3 map_to_gamut(const Vec3& rgb, GamutMapping mapping, const Vec3& luminance,
                                ColourOf what) noexcept;

/// What happens to all colours of an image, or of a list, together.
enum class RangeMapping {
    none,
    clamp,      ///< each channel of each into [0, 1]
    normalise,  ///< all divided by the largest channel of all, where that is > 0
};

/// "none", "clamp" or "normalise". @throws InputError for any other name.
[[nodiscard]] RangeMapping range_mapping_from_name(std::string_view name);

void map_range(std::span<Vec3> colours, RangeMapping mapping) noexcept;

}  // namespace nacre::spectral
