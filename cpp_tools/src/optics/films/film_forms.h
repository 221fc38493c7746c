// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "nacre/core/vector_clones.h"

/// @file
/// The algebra of the forms of film_models.h in real numbers, for one film and for lanes of them.
/// r01 and r12 are the coefficients of the faces; a + ib = r12 e^{iδ} is what comes back from the
/// lower one after a round trip, bottom = |r12|². Lossless faces have t01 t10 = 1 − r01².
/// Reflectances, but for `…_passed`, which are transmittances.

namespace nacre::optics::forms {

NACRE_INLINE double airy(double r01, double a, double b)
{
    const double up = r01 + a, both = 1.0 + r01 * a, turned = r01 * b;
    return (up * up + b * b) / (both * both + turned * turned);
}

/// Of (a + ib)(1 − r01 (a + ib)) t01 t10 + r01.
NACRE_INLINE double cut_series(double r01, double a, double b)
{
    const double through = 1.0 - r01 * r01;
    const double re = r01 + through * (a - r01 * (a * a - b * b));
    const double im = through * b * (1.0 - 2.0 * r01 * a);
    return re * re + im * im;
}

/// What leaves below after none, one and two round trips: |t01 t12 (1 + ρ + ρ²)|² times the ratio
/// of n cosθ, with ρ = −r01 (a + ib).
NACRE_INLINE double cut_series_passed(double r01, double bottom, double a, double b)
{
    const double rho_re = -r01 * a, rho_im = -r01 * b;
    const double re = 1.0 + rho_re + rho_re * rho_re - rho_im * rho_im;
    const double im = rho_im * (1.0 + 2.0 * rho_re);
    return (1.0 - r01 * r01) * (1.0 - bottom) * (re * re + im * im);
}

NACRE_INLINE double opaque_base(double r01, double bottom, double a)
{
    const double top = r01 * r01, mixed = 2.0 * r01 * a;
    return (top + bottom + mixed) / (1.0 + top * bottom + mixed);
}

/// Of two mirrors of reflectance `mirror` that shift no phase.
/// @param versine  1 − cosδ = 2 sin²(δ/2)
NACRE_INLINE double etalon(double mirror, double versine)
{
    const double loss = 1.0 - mirror, swing = 2.0 * mirror * versine;
    return swing / (loss * loss + swing);
}

NACRE_INLINE double etalon_passed(double mirror, double versine)
{
    const double loss = 1.0 - mirror;
    return loss * loss / (loss * loss + 2.0 * mirror * versine);
}

/// Mean of the fraction of x over [x1, x2], x1 ≤ x2, from its integral ⌊x⌋/2 + frac(x)²/2.
NACRE_INLINE double mean_fraction(double x1, double x2)
{
    const double low = std::floor(x1), high = std::floor(x2);
    const double f1 = x1 - low, f2 = x2 - high, jumps = high - low;
    const double width = jumps + f2 - f1;
    return jumps > 0.0 ? 0.5 * (jumps + (f2 - f1) * (f2 + f1)) / width : 0.5 * (f1 + f2);
}

}  // namespace nacre::optics::forms
