// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_request.h"

/// @file
/// Reflectance over the facet's cosine as a sum of powers, which renderers evaluate at each
/// microfacet.

namespace nacre::lut {

/// R(cosθ) ≈ Σ c_k (1 − cosθ)^e_k, e_0 = 0, for every value of the variation with the same
/// exponents. Each term is a Schlick reflectance of f0 = 0, f90 = c_k, of any sign.
struct SchlickFit {
    std::vector<double> exponents;
    Table coefficients;                ///< `R_schlick`: column k holds c_k
    std::vector<spectral::Vec3> bare;  ///< the same row for the bare substrate
    double error_max, error_rms;       ///< of R, for cosθ ≥ 0.05
};

/// Exponents by least squares (variable projection), as few terms as stay within `allowed`, and at
/// most 16: terms more only trade smaller errors for larger coefficients.
///
/// @param request  of the film; its transmittance is not looked at
/// @param smooth   its table of R, which gives the number of columns
/// @throws InputError when the stack is not valid
[[nodiscard]] SchlickFit fit_schlick(const FilmTableRequest& request, const Table& smooth,
                                     double allowed = 0.01);

}  // namespace nacre::lut
