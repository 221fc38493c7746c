// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "stacks/coherent_packet.h"

/// @file
/// Layers whose phase is spread: by a thickness that varies under the eye, or by a band of
/// wavelengths.
///
/// The phase of one passage through such a layer is normally distributed about that of its mean
/// thickness, independently of the other layers; its attenuation is that of the mean thickness. So
/// the m-th term of the Airy series of one layer is multiplied by exp(−(2mσ)²/2), with σ the
/// standard deviation of one passage (physics of a Gaussian band or thickness: Katsidis, Siapkas,
/// Appl. Opt. 41, 3978, 2002).

namespace nacre::optics::detail {

struct MeanPower {
    Real R, T;
};

/// Whether any layer has a spread.
[[nodiscard]] bool has_spread(std::span<const Layer> layers) noexcept;

/// R and T of `layers` (from `above` to `below`), the mean over the phases of those that have a
/// spread. One such layer: the Airy series in closed form but for its damped sum. Several: the
/// moments ⟨r^k r*^l⟩ of the reflection coefficient, exact up to an order K at which the product
/// |r_b r|^K of neighbouring reflections has died away; at most 512, enough for 1e-9 where
/// |r_b r| ≤ 0.98.
[[nodiscard]] MeanPower mean_response(const Incidence& incidence, Complex above,
                                      std::span<const Layer> layers, Complex below,
                                      Polarisation polarisation);

}  // namespace nacre::optics::detail
