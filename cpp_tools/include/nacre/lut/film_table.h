// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/lut/film_request.h"

/// @file
/// Colour of a film stack over angle and thickness.

namespace nacre::lut {

/// @throws InputError when the stack is not valid, or the tolerance cannot be met within
///         `max_texels` and that is not accepted (the message states the error that was reached),
///         or it was cancelled.
[[nodiscard]] FilmTables bake_film_tables(const FilmTableRequest& request);

/// Exact colour at one angle and value of the variation, by the same sum over 471 wavelengths that
/// the tables use.
[[nodiscard]] FilmColour exact_film_colour(const FilmTableRequest& request, double cos_theta,
                                           double variation_value);

/// The same at `count` ≥ 2 equal steps of the variation, from `variation.min` to its `max`.
/// @pre the request has a variation
[[nodiscard]] std::vector<FilmColour> exact_film_ramp(const FilmTableRequest& request,
                                                      double cos_theta, std::size_t count);

}  // namespace nacre::lut
