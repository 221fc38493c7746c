// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "nacre/core/vector_clones.h"

/// @file
/// Functions without branches for loops that the compiler turns into vector code. Library functions
/// would stop it, and differ in the last bit between systems.

namespace nacre::optics::lane {

/// A complex number whose product is four multiplications: std::complex checks for NaN.
struct C {
    double re, im;
};
NACRE_INLINE C operator+(C a, C b)
{
    return {a.re + b.re, a.im + b.im};
}
NACRE_INLINE C operator-(C a, C b)
{
    return {a.re - b.re, a.im - b.im};
}
NACRE_INLINE C operator*(C a, C b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
NACRE_INLINE C operator*(double a, C b)
{
    return {a * b.re, a * b.im};
}
NACRE_INLINE double norm(C a)
{
    return a.re * a.re + a.im * a.im;
}
NACRE_INLINE C reciprocal(C a)
{
    const double scale = 1.0 / norm(a);
    return {a.re * scale, -a.im * scale};
}

/// Root with Re ≥ 0, Im ≥ 0 of a number with Im ≥ 0. The small part comes from the product of the
/// parts, since their squares would cancel where absorption is weak. Zero becomes 1e-12, which is
/// far below what matters, so that callers can divide.
NACRE_INLINE C upper_sqrt(C z)
{
    const double modulus = std::sqrt(z.re * z.re + z.im * z.im) + 1e-24;
    const double large = std::sqrt(0.5 * (modulus + std::abs(z.re)));
    const double small = 0.5 * z.im / large;
    return z.re >= 0.0 ? C{large, small} : C{small, large};
}

inline constexpr double kRound = 6755399441055744.0;  ///< 1.5·2^52: adding it rounds to an integer

/// e^{2πi·turns}. Turns are reduced without error; the remainder, at most 1/8, by Taylor series
/// whose next terms are below 1e-18.
NACRE_INLINE C cis_turns(double turns)
{
    const double fraction = turns - ((turns + kRound) - kRound);
    const double quarter = (4.0 * fraction + kRound) - kRound;  // -2, -1, 0, 1, 2
    const double x = 2.0 * std::numbers::pi * (fraction - 0.25 * quarter);
    const double y = x * x;
    const double sine =
        x * (1.0 + y * (-1.0 / 6 +
                        y * (1.0 / 120 +
                             y * (-1.0 / 5040 +
                                  y * (1.0 / 362880 + y * (-1.0 / 39916800 +
                                                           y * (1.0 / 6227020800.0 +
                                                                y * (-1.0 / 1307674368000.0))))))));
    const double cosine =
        1.0 +
        y * (-1.0 / 2 +
             y * (1.0 / 24 +
                  y * (-1.0 / 720 + y * (1.0 / 40320 + y * (-1.0 / 3628800 +
                                                            y * (1.0 / 479001600.0 +
                                                                 y * (-1.0 / 87178291200.0 +
                                                                      y / 20922789888000.0)))))));
    const double turn = std::abs(quarter);
    const double c = turn == 1.0 ? sine : cosine, s = turn == 1.0 ? cosine : sine;
    const double c_sign = turn == 2.0 ? -1.0 : (quarter == 1.0 ? -1.0 : 1.0);
    const double s_sign = turn == 2.0 ? -1.0 : (quarter == -1.0 ? -1.0 : 1.0);
    return {c_sign * c, s_sign * s};
}

/// e^x for x ≤ 0; exactly 0 below -700.
NACRE_INLINE double exp_decay(double x)
{
    constexpr double kLn2High = 0x1.62e42fefa3800p-1, kLn2Low = 0x1.ef35793c76730p-45;
    const double shifted = x * std::numbers::log2e + kRound;
    const double k = shifted - kRound;
    const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| ≤ ln2/2
    double sum = 1.0 / 6227020800.0;
    sum = sum * r + 1.0 / 479001600.0;
    sum = sum * r + 1.0 / 39916800.0;
    sum = sum * r + 1.0 / 3628800.0;
    sum = sum * r + 1.0 / 362880.0;
    sum = sum * r + 1.0 / 40320.0;
    sum = sum * r + 1.0 / 5040.0;
    sum = sum * r + 1.0 / 720.0;
    sum = sum * r + 1.0 / 120.0;
    sum = sum * r + 1.0 / 24.0;
    sum = sum * r + 1.0 / 6.0;
    sum = sum * r + 0.5;
    sum = sum * r + 1.0;
    sum = sum * r + 1.0;
    // The low bits of `shifted` are k: added to the exponent they multiply by 2^k.
    const auto exponent = std::bit_cast<std::uint64_t>(shifted) << 52U;
    const double scaled = std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) + exponent);
    return x < -700.0 ? 0.0 : scaled;
}

}  // namespace nacre::optics::lane
