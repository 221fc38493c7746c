// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "nacre/optics/film_stack.h"

/// @file
/// Adjacent coherent layers between two half-spaces, in extended precision.
///
/// `long double` has 64 mantissa bits on x86-64 and 113 on most 64-bit Arm systems: what it adds
/// over double absorbs the loss near a critical angle (q = 0) and in the phase of a
/// millimetre-thick layer (thousands of turns), so that the results are good to about 1e-15. The
/// arrays of stack_batch.h use plain double.

namespace nacre::optics::detail {

using Real = long double;
using Extended = std::complex<Real>;

/// What Snell's law keeps the same in every medium: n² sin²θ = n_0² − (n_0 cosθ_0)².
struct Incidence {
    Complex ambient;     ///< index of the medium in which the angle is given
    double cos_ambient;  ///< of that angle
    double wavelength_nm;
};

/// Wave-vector component across the interfaces over 2π/λ: q = n cosθ, on the branch with Im q > 0,
/// or Re q > 0 where Im q = 0.
[[nodiscard]] Extended normal_index(const Incidence& incidence, Complex n) noexcept;

/// Tangential field ratio of one wave going down: H/E = q for s, E/H = q/n² for p. One recursion
/// then serves both; it works on E for s and on H for p.
[[nodiscard]] Extended tilted_admittance(Extended q, Complex n, Polarisation polarisation) noexcept;

/// Ratios of E for s, of H for p, and of power.
struct PacketResponse {
    Extended r, t;
    Real R, T;
};

/// Response of `layers` (from `above` to `below`) to light that comes from `above`.
[[nodiscard]] PacketResponse respond(const Incidence& incidence, Complex above,
                                     std::span<const Layer> layers, Complex below,
                                     Polarisation polarisation);

/// Real part of the power flux, over that of the incident wave, at the top of each layer and in the
/// substrate: layers + 1 values. Between neighbours lies what a layer absorbs.
[[nodiscard]] std::vector<Real> power_flux(const Incidence& incidence, Complex above,
                                           std::span<const Layer> layers, Complex below,
                                           Polarisation polarisation);

}  // namespace nacre::optics::detail
