// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_request.h"
#include "nacre/lut/inner_tables.h"
#include "nacre/lut/rough_glass_tables.h"

/// @file
/// Tables for the time while someone edits a stack: of a given size, in a hundredth of the time of
/// a bake, and good to a few ΔE00 where a bake states its error.

namespace nacre::lut {

/// Width and height of a table; of one with slices, of all of them together.
struct TexelSize {
    int width, height;
};

/// R, and T where the request has it: exact on a coarse grid, cubic in between. Errors are NaN.
/// @param request  its size, tolerance and precision are not looked at
/// @throws InputError when the stack is not valid
[[nodiscard]] FilmTables preview_film_tables(const FilmTableRequest& request, TexelSize size);

/// `R_rough` and `T_rough` for these smooth tables, which need not be of the final size. Further
/// bounces by the hemispherical means of each channel (Kulla and Conty 2017); there is no
/// `further`.
[[nodiscard]] RoughTables preview_rough_tables(const FilmTables& smooth, TexelSize size);

/// The same as bake_rough_glass_tables() makes them; the first of an index takes half a second.
[[nodiscard]] RoughTables preview_rough_glass_tables(const FilmTables& smooth, double index,
                                                     TexelSize size);

/// `R_inner` and `T_inner`, exact on fewer rows.
/// @pre the substrate is clear
[[nodiscard]] InnerTables preview_inner_tables(const FilmTableRequest& request, int height);

}  // namespace nacre::lut
