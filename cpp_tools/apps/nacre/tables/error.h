// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_table.h"
#include "nacre/spectral/colour.h"

namespace nacre::tool {

/// Measures `error_max` and `error_mean` of a table again after its texels were changed (rounded to
/// half): ΔE00 of the bilinear value half-way between texels against the exact one.
void measure_error(lut::Table& table, const lut::FilmTableRequest& request,
                   const spectral::ColourSpace& space);

}  // namespace nacre::tool
