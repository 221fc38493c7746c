// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>

/// @file
/// Amplitude coefficients of one planar interface between isotropic media.
///
/// Conventions (normative text: cpp_tools/doc/conventions.md)
///   time factor  exp(-i w t), so an absorbing medium has n + i k with k >= 0
///   p sign       Verdet: r_p = -r_s at normal incidence
///
/// Reference: Born & Wolf 1999, section 1.5.2. Branch rule: Byrnes 2016, appendix D.

namespace nacre::optics {

using Complex = std::complex<double>;

/// Ratios of electric-field amplitudes; square the modulus of r for reflectance.
struct FresnelAmplitudes {
    Complex r_s, r_p;
    Complex t_s, t_p;
};

/// Cosine of the angle in medium `n_t` for light that has `cos_i` in `n_i`, on the branch that
/// decays, or else carries power, away from the interface (Im q > 0, or Re q > 0 where Im q = 0).
[[nodiscard]] Complex forward_cosine(Complex n_i, Complex n_t, Complex cos_i) noexcept;

/// @pre  `cos_t == forward_cosine(n_i, n_t, cos_i)`; passed in because a stack already has it.
/// @post Matched indices give r = 0 and t = 1.
[[nodiscard]] FresnelAmplitudes fresnel_amplitudes(Complex n_i, Complex n_t, Complex cos_i,
                                                   Complex cos_t) noexcept;

}  // namespace nacre::optics
