// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "nacre/optics/dispersive_stack.h"
#include "nacre/spectral/colour_quadrature.h"

/// @file
/// The colour of one stack at one angle, from as few wavelengths as it takes.

namespace nacre::optics {

struct StackColour {
    spectral::Vec3 reflectance, transmittance;  ///< in the space of the weights
    std::size_t evaluations;                    ///< wavelengths at which the stack was computed
};

/// Colours from the wavelengths of a quadrature, whatever the stack does in between. Indices are
/// looked up once. One object for one thread.
class SummedColours {
public:
    /// @throws InputError where a medium has no data or is none that `validate` accepts; the field
    ///         is `n[i]`
    SummedColours(const DispersiveStack& stack, const spectral::ColourQuadrature& quadrature);
    SummedColours(SummedColours&&) noexcept;
    SummedColours& operator=(SummedColours&&) noexcept;
    SummedColours(const SummedColours&) = delete;
    SummedColours& operator=(const SummedColours&) = delete;
    ~SummedColours();

    /// @param thickness_nm  one a layer, ≥ 0 and finite
    [[nodiscard]] StackColour at(std::span<const double> thickness_nm, const ObliqueLight& light);

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// Colours from as few wavelengths as they take.
///
/// A reflectance oscillates and may have lines of any width; the amplitudes whose quotient it is,
/// r = b/a, are as smooth as the phase of the stack lets them be. a, b and T|a|² are interpolated
/// by Chebyshev polynomials in wavenumber through as many wavelengths as that phase asks for, and
/// twice as many while the last coefficients still count. Their quotients are summed every
/// nanometre and, where a changes by much of itself from one to the next, in between: a line is
/// found however narrow it is. Stacks whose media are not smooth enough are summed at 1 nm, very
/// thick ones, of tenths of a millimetre, at as little as 0.05 nm; those with incoherent layers at
/// 1 nm.
///
/// One object for one thread.
class AdaptiveColours {
public:
    AdaptiveColours(DispersiveStack stack, const spectral::ColourWeights& weights);
    AdaptiveColours(AdaptiveColours&&) noexcept;
    AdaptiveColours& operator=(AdaptiveColours&&) noexcept;
    AdaptiveColours(const AdaptiveColours&) = delete;
    AdaptiveColours& operator=(const AdaptiveColours&) = delete;
    ~AdaptiveColours();

    /// @param thickness_nm  one a layer, ≥ 0 and finite
    /// @throws InputError where a medium has no data or is none that `validate` accepts; the field
    ///         is `n[i]`
    [[nodiscard]] StackColour at(std::span<const double> thickness_nm, const ObliqueLight& light);

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace nacre::optics
