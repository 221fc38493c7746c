// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// @file
/// Many stacks of one depth at once, in double precision, for tables and arrays.
///
/// A lane is one (wavelength, angle, …). The loops over lanes are free of branches and library
/// calls, so that the compiler turns them into vector code for the widest unit of the machine;
/// without contraction or reordering the results are the same bits on every one of them.

namespace nacre::optics {

inline constexpr std::size_t kLanes = 32;

struct alignas(64) Lanes : std::array<double, kLanes> {};

struct ComplexLanes {
    Lanes re, im;
};

struct LaneLayer {
    ComplexLanes n;
    Lanes waves;  ///< thickness over vacuum wavelength, d/λ
};

/// Coherent layers between the half-spaces `above` and `below`. The angle may be given in a medium
/// further up: q² = n² − n_0² + (n_0 cosθ_0)² in every layer.
struct LaneStack {
    Lanes n_0, cos_0;  ///< cos_0 in (0, 1]
    ComplexLanes above, below;
    std::vector<LaneLayer> layers;
};

/// Ratios of E (r, t) and of power (R, T).
struct LaneResponse {
    ComplexLanes r, t;
    Lanes R, T;
};

struct BatchResponse {
    LaneResponse s, p;
    /// Bound on what double precision loses in R, T, r, t, near a critical angle inside the stack
    /// and in thick layers; where it is too much, take `stack_amplitudes`.
    Lanes doubt;
};

/// Agrees with `stack_amplitudes` to 1e-13 times the number of layers, apart from `doubt`.
void stack_batch(const LaneStack& stack, BatchResponse& response) noexcept;

/// Mean of s and p of a stack in which some layers are incoherent, as `stack_power`.
/// @pre coherent.size() == stack.layers.size()
void mixed_batch(const LaneStack& stack, const std::vector<bool>& coherent, Lanes& R, Lanes& T);

/// Reflectance and transmittance as a function of the thickness of one layer only: everything
/// above and below it is folded into a map of its phase, once. Per lane and polarisation, with
/// E = e^{2iδ} = e·e^{iφ} of that layer, r = (a + bE)/(c + dE); stored are the real coefficients of
///     |a + bE|² = n0 + n1 e² + e (n2 cosφ + n3 sinφ),   |c + dE|² likewise,   T = τ e / |c + dE|².
class PhaseMap {
public:
    /// @param varying  index of the layer whose thickness is free; its `waves` are not read
    PhaseMap(const LaneStack& stack, std::size_t varying) noexcept;

    /// Mean of s and p at `R.size()` equal steps of thickness; both arguments are thickness over
    /// wavelength, ≥ 0. The phase is multiplied on, so that a row costs no trigonometry; its error
    /// grows by one rounding a row.
    /// @pre R.size() == T.size()
    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
               std::span<Lanes> T) const noexcept;

    struct Coefficients {
        Lanes n0, n1, n2, n3, d0, d1, d2, d3, tau;
    };

private:
    Coefficients s_, p_;
    ComplexLanes q_;
};

/// Reflectance and transmittance as a function of a factor on every thickness. Indices, admittances
/// and the phases of one step are worked out once; a row then costs only the recursion.
class ScaledStack {
public:
    explicit ScaledStack(const LaneStack& stack);

    /// Mean of s and p at the factors first, first + step, …
    /// @pre R.size() == T.size(), first ≥ 0, step ≥ 0
    void march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const;

    struct Layer {
        ComplexLanes q, inverse_q, n2, inverse_n2;
        Lanes waves;
    };

private:
    LaneStack ends_;  ///< without its layers
    std::vector<Layer> layers_;
};

}  // namespace nacre::optics
