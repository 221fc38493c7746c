// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nacre/kinds/film_preview.h"
#include "nacre/spectral/wavelengths.h"

/// @file
/// The tables of a film where a renderer's three channels are three bands of wavelengths.

namespace nacre::kinds {

/// What each channel of a pass is: weights of the nanometres, 1 together.
using BandPass = std::array<spectral::Sampled, 3>;

/// Tables of these roles and sizes, those of a compiled film, with the reflectance in each band in
/// place of a colour; pass lies below pass, so that a table has passes.size() times the rows of its
/// layout. `R_schlick` and the lobes of the substrate (`lobe_R`, `lobe_T`) are left out: nodes do
/// not read them.
///
/// Texels are exact to single precision; between them the error is that of the layout, which the
/// film's own tables chose for colours. Errors are NaN.
/// @param options  of the media's data; illuminant, space and tolerance are not looked at
/// @throws InputError with the template's lines; or where a table does not belong to such a film,
///         or cannot be of that size
[[nodiscard]] std::vector<lut::Table> band_tables(const MaterialTemplate& source,
                                                  const CompileOptions& options,
                                                  std::span<const BandPass> passes,
                                                  std::span<const TableLayout> layout);

/// Of a film at its thickest, in nm: Σ Re(n) d of the coherent layers at the d line, which tells
/// how narrow its fringes are.
[[nodiscard]] double optical_thickness_nm(const MaterialTemplate& source,
                                          const CompileOptions& options);

/// Reflectance of a film at thicknesses from 0.9 times its thickest to that, evenly; of one that
/// does not vary all the same.
/// @param cos_theta  of the angle of incidence, in the ambient
/// @pre count > 1
[[nodiscard]] std::vector<spectral::Sampled> film_fringes(const MaterialTemplate& source,
                                                          const CompileOptions& options, int count,
                                                          double cos_theta = 1.0);

}  // namespace nacre::kinds
