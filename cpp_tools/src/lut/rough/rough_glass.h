// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/lut/film_request.h"
#include "nacre/optics/rough_glass.h"

namespace nacre::lut {

/// Tints of the lobes of reflecting and refracting facets, of a film with the colours of this row.
/// @param white  the colour of the light
[[nodiscard]] FilmColour glass_colour(const Table& reflectance, const Table& transmittance,
                                      std::size_t row, const optics::GlassFacets& facets,
                                      const spectral::Vec3& white);

/// What all columns of slices of this width see, [side][slice][column].
[[nodiscard]] std::vector<optics::GlassFacets> all_glass_facets(double index, std::size_t width,
                                                                std::size_t columns);

}  // namespace nacre::lut
