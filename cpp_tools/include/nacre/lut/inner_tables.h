// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_request.h"

/// @file
/// A film seen from below by light of every direction: what a matt base under it needs to know.

namespace nacre::lut {

/// Means over the hemisphere of the substrate, weighted by the cosine there: one column, and rows
/// as asked for.
struct InnerTables {
    Table reflectance;    ///< `R_inner`: what returns to the base, total reflection included
    Table transmittance;  ///< `T_inner`: what leaves
};

/// @param height  rows; 1 without a variation
/// @pre the substrate is clear
/// @throws InputError when the stack is not valid
[[nodiscard]] InnerTables bake_inner_tables(const FilmTableRequest& request, int height);

/// The request for the same film lit from below: ambient and substrate change places.
[[nodiscard]] FilmTableRequest seen_from_below(FilmTableRequest request);

}  // namespace nacre::lut
