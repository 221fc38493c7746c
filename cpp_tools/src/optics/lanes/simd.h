// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "nacre/core/vector_clones.h"
#include "nacre/optics/lanes.h"

/// @file
/// Four doubles or eight floats at a time in the compiler's own vector types (GCC, Clang), which it
/// lowers to SSE2, AVX2, AVX-512VL or NEON. Sources that use it are compiled with contraction:
/// where the machine fuses products and sums, results differ from the others' by roundings.

namespace nacre::optics::simd {

template <class Real>
struct VectorOf;
template <>
struct VectorOf<double> {
    using Type [[gnu::vector_size(32)]] = double;
    using Bits [[gnu::vector_size(32)]] = unsigned long long;  // sums wrap
};
template <>
struct VectorOf<float> {
    using Type [[gnu::vector_size(32)]] = float;
    using Bits [[gnu::vector_size(32)]] = unsigned;
};
template <class Real>
using Vector = typename VectorOf<Real>::Type;

template <class Real>
inline constexpr std::size_t kWidthOf = sizeof(Vector<Real>) / sizeof(Real);
static_assert(kLanes % kWidthOf<float> == 0);

/// A complex number whose product is four multiplications: std::complex checks for NaN.
template <class Real>
struct Complex {
    Vector<Real> re, im;
};

using V = Vector<double>;
using Bits = VectorOf<double>::Bits;
using C = Complex<double>;
inline constexpr std::size_t kWidth = kWidthOf<double>;

template <class Real>
NACRE_INLINE Vector<Real> load(const LanesOf<Real>& lanes, std::size_t i)
{
    Vector<Real> value;
    std::memcpy(&value, lanes.data() + i, sizeof value);
    return value;
}
template <class Real>
NACRE_INLINE void store(LanesOf<Real>& lanes, std::size_t i, Vector<Real> value)
{
    std::memcpy(lanes.data() + i, &value, sizeof value);
}
template <class Real>
NACRE_INLINE Complex<Real> load(const ComplexLanesOf<Real>& lanes, std::size_t i)
{
    return {load(lanes.re, i), load(lanes.im, i)};
}
template <class Real>
NACRE_INLINE void store(ComplexLanesOf<Real>& lanes, std::size_t i, Complex<Real> value)
{
    store(lanes.re, i, value.re);
    store(lanes.im, i, value.im);
}
template <class Real>
NACRE_INLINE Complex<Real> operator+(Complex<Real> a, Complex<Real> b)
{
    return {a.re + b.re, a.im + b.im};
}
template <class Real>
NACRE_INLINE Complex<Real> operator-(Complex<Real> a, Complex<Real> b)
{
    return {a.re - b.re, a.im - b.im};
}
template <class Real>
NACRE_INLINE Complex<Real> operator*(Complex<Real> a, Complex<Real> b)
{
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
template <class Real>
NACRE_INLINE Complex<Real> operator*(Vector<Real> a, Complex<Real> b)
{
    return {a * b.re, a * b.im};
}
template <class Real>
NACRE_INLINE Vector<Real> norm(Complex<Real> a)
{
    return a.re * a.re + a.im * a.im;
}
NACRE_INLINE C reciprocal(C a)
{
    const V scale = 1.0 / norm(a);
    return {a.re * scale, -a.im * scale};
}

/// All lanes +0 or −0.
NACRE_INLINE bool all_zero(V x)
{
    const Bits bits = (Bits)x << 1;
    return ((bits[0] | bits[1]) | (bits[2] | bits[3])) == 0;
}

NACRE_INLINE V absolute(V x)
{
    return (V)((Bits)x & 0x7fff'ffff'ffff'ffffULL);
}
NACRE_INLINE Vector<float> absolute(Vector<float> x)
{
    return (Vector<float>)((VectorOf<float>::Bits)x & 0x7fff'ffffU);
}
NACRE_INLINE V square_root(V x)
{
    V root;
    for (std::size_t i = 0; i < kWidth; ++i) root[i] = std::sqrt(x[i]);
    return root;
}
NACRE_INLINE Vector<float> square_root(Vector<float> x)
{
    Vector<float> root;
    for (std::size_t i = 0; i < kWidthOf<float>; ++i) root[i] = std::sqrt(x[i]);
    return root;
}

/// A root and what its working out leaves.
struct Root {
    C value;
    V modulus;  ///< of its square
    V largest;  ///< max(|Re|, |Im|)
    V inverse;  ///< of `largest`
};

/// Root with Re ≥ 0, Im ≥ 0 of a number with Im ≥ 0. The small part comes from the product of the
/// parts, since their squares would cancel where absorption is weak. Zero becomes 1e-12, which is
/// far below what matters, so that callers can divide.
NACRE_INLINE Root upper_root(C z)
{
    // The root of a square is the number itself, to the last bit: clear media are spared one.
    const V modulus = (all_zero(z.im) ? absolute(z.re) : square_root(norm(z))) + 1e-24;
    const V large = square_root(0.5 * (modulus + absolute(z.re)));
    const V inverse = 1.0 / large, small = 0.5 * z.im * inverse;
    const auto right = z.re >= 0.0;
    return {{right ? large : small, right ? small : large}, modulus, large, inverse};
}

inline constexpr double kRound = 6755399441055744.0;  ///< 1.5·2^52: adding it rounds to an integer

/// e^{2πi·turns}, each part within 1 unit in the last place of 1, i.e. 3e-16. Turns are reduced
/// without error; the remainder, at most 1/8, by Taylor series whose next terms are below 1e-18,
/// summed by Estrin's scheme.
NACRE_INLINE C cis_turns(V turns)
{
    const V fraction = turns - ((turns + kRound) - kRound);
    const V shifted = 4.0 * fraction + kRound;
    const Bits quarter = (Bits)shifted;
    const V x = (2.0 * std::numbers::pi) * (fraction - 0.25 * (shifted - kRound));
    const V y = x * x, y2 = y * y, y4 = y2 * y2;
    const V s01 = 1.0 + y * (-1.0 / 6.0), s23 = 1.0 / 120.0 + y * (-1.0 / 5040.0),
            s45 = 1.0 / 362880.0 + y * (-1.0 / 39916800.0),
            s67 = 1.0 / 6227020800.0 + y * (-1.0 / 1307674368000.0);
    const V sine = x * ((s01 + y2 * s23) + y4 * (s45 + y2 * s67));
    const V c01 = 1.0 + y * -0.5, c23 = 1.0 / 24.0 + y * (-1.0 / 720.0),
            c45 = 1.0 / 40320.0 + y * (-1.0 / 3628800.0),
            c67 = 1.0 / 479001600.0 + y * (-1.0 / 87178291200.0);
    const V cosine = (c01 + y2 * c23) + y4 * (c45 + y2 * c67 + y4 * (1.0 / 20922789888000.0));
    // The low bits of `shifted` are the quarter, in two's complement.
    const auto odd = (quarter & 1) != 0;
    const V re = odd ? sine : cosine, im = odd ? cosine : sine;
    const Bits re_sign = ((quarter + 1) & 2) << 62, im_sign = (quarter & 2) << 62;
    return {(V)((Bits)re ^ re_sign), (V)((Bits)im ^ im_sign)};
}

inline constexpr double kWeak = 1.0 / 32.0;

/// e^x for |x| ≤ kWeak within 1 unit in the last place: the next term is below 3e-17.
NACRE_INLINE V exp_weak(V x)
{
    const V x2 = x * x;
    const V p23 = 0.5 + x * (1.0 / 6.0), p45 = 1.0 / 24.0 + x * (1.0 / 120.0),
            p67 = 1.0 / 720.0 + x * (1.0 / 5040.0);
    return 1.0 + (x + x2 * (p23 + x2 * (p45 + x2 * p67)));
}

/// e^x for x ≤ 0 within 2.5 units in the last place; exactly 0 below -700. Most layers absorb so
/// little that a short series does. A lane takes it whatever its neighbours are: results do not
/// depend on how a caller arranges its arrays.
NACRE_INLINE V exp_decay(V x)
{
    const V weak = exp_weak(x);
    const auto strong = x < -kWeak;
    if (((strong[0] | strong[1]) | (strong[2] | strong[3])) == 0) return weak;
    constexpr double kLn2High = 0x1.62e42fefa3800p-1, kLn2Low = 0x1.ef35793c76730p-45;
    const V shifted = x * std::numbers::log2e + kRound;
    const V k = shifted - kRound;
    const V r = (x - k * kLn2High) - k * kLn2Low;  // |r| ≤ ln2/2
    const V r2 = r * r, r4 = r2 * r2, r8 = r4 * r4;
    const V p23 = 0.5 + r * (1.0 / 6.0), p45 = 1.0 / 24.0 + r * (1.0 / 120.0),
            p67 = 1.0 / 720.0 + r * (1.0 / 5040.0), p89 = 1.0 / 40320.0 + r * (1.0 / 362880.0),
            pab = 1.0 / 3628800.0 + r * (1.0 / 39916800.0);
    const V tail =
        (r2 * p23 + r4 * (p45 + r2 * p67)) + r8 * (p89 + r2 * pab + r4 * (1.0 / 479001600.0));
    const V sum = 1.0 + (r + tail);  // the large terms last: one rounding each
    // The low bits of `shifted` are k: added to the exponent they multiply by 2^k.
    const V scaled = (V)((Bits)sum + ((Bits)shifted << 52));
    return strong ? (V)((Bits)scaled & (Bits)(x >= -700.0)) : weak;
}

}  // namespace nacre::optics::simd
