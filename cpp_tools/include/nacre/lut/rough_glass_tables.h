// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/lut/rough_tables.h"
#include "nacre/optics/rough_glass.h"

/// @file
/// Films on rough solid glass, seen from both sides, as tints of the lobes that a renderer has.

namespace nacre::lut {

/// Rough tables of glass hold the slices of the view from outside, then those from inside.
inline constexpr int kGlassSides = 2;

/// The view that a column of a slice, `x` in [0, 1], belongs to. From outside x is cos_theta. From
/// inside, where R has a root at the border of total reflection, it is (1 + c)/2 up to there, c the
/// cosine in the ambient, and (1 − d)/2 beyond, d the decay √(n² sin²θ − 1) over its most.
[[nodiscard]] optics::GlassView glass_view(double x, double roughness, double index, int side);

/// Of reflecting facets and of refracting ones, each lobe with its own albedo (GlassFacets::mirror
/// and window). What one bounce does not send away goes on as it came, again and again: of a film
/// that loses the share a of all colours in a bounce, 1/(1 − a) as much leaves as after the first.
/// So tints times albedos of a film that absorbs nothing are 1 together.
/// @param smooth  R and T of the same request
/// @param index   of the substrate, relative to the ambient
/// @throws InputError when the stack is not valid
[[nodiscard]] RoughTables bake_rough_glass_tables(const FilmTableRequest& request,
                                                  const FilmTables& smooth, double index);

/// What bare glass does in one bounce, over the same albedos: the means of its F and 1 − F, by
/// which the colours of lobes that bring F along are divided. Grey, so that they are the same in
/// every space. `lobe_R` and `lobe_T` over the cosine in the ambient, `lobe_R_rough` and
/// `lobe_T_rough` in slices.
/// @param width  of a slice
[[nodiscard]] std::vector<Table> bake_lobe_tables(double index, int width);

}  // namespace nacre::lut
