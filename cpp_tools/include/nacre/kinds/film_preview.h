// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nacre/kinds/film.h"
#include "nacre/lut/preview.h"
#include "nacre/spectral/spectrum.h"

/// @file
/// New texels for a compiled film whose stack is being edited.

namespace nacre::kinds {

/// A table that a compiled material has.
struct TableLayout {
    TableRole role;
    lut::TexelSize size;
};

/// Tables of these roles and sizes, without stated errors; the shader and the graphs that read the
/// old ones go on reading them. Fits, further bounces and the lobes of the substrate
/// (`R_schlick`, `R_further`, `lobe_R`) are left out: they wait for compile().
///
/// @param options  tolerance is not looked at
/// @throws InputError with the template's lines; or where a table does not belong to such a film,
///         or cannot have this size
[[nodiscard]] std::vector<lut::Table> preview_tables(const MaterialTemplate& source,
                                                     const CompileOptions& options,
                                                     std::span<const TableLayout> layout);

/// What a film reflects and lets pass at one angle, unpolarised.
struct FilmSpectrum {
    spectral::Sampled reflectance, transmittance;
    lut::FilmColour colour;  ///< of both, exact
};

/// @param cos_theta  in the ambient, in (0, 1]
/// @param value      of what varies, nm or a factor; not held to its range; else not looked at
/// @throws InputError with the template's lines
[[nodiscard]] FilmSpectrum film_spectrum(const MaterialTemplate& source,
                                         const CompileOptions& options, double cos_theta,
                                         double value);

}  // namespace nacre::kinds
