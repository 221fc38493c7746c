// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_request.h"
#include "nacre/lut/rough_slices.h"

/// @file
/// Films on rough surfaces of GGX microfacets, as tints of the one lobe that a renderer has for
/// them.

namespace nacre::lut {

/// @param smooth  the tables of the same request: they give the number of columns that means are
///                taken over, and the size
/// @throws InputError when the stack is not valid
[[nodiscard]] RoughTables bake_rough_tables(const FilmTableRequest& request,
                                            const FilmTables& smooth);

}  // namespace nacre::lut
