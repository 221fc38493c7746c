// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "nacre/optics/lanes.h"

/// @file
/// Many stacks of one depth at once, for tables and arrays.
///
/// Double precision; what a table does once a row there is in single precision too, with twice as
/// many lanes in a vector.
///
/// A lane is one (wavelength, angle, …). The work is done in vectors of lanes for the instruction
/// set that the machine has; from one to another results differ by roundings, far below 1e-13. The
/// place of a lane, its neighbours and the number of threads never change a bit.

namespace nacre::optics {

namespace detail {
class AngledStack;
}

/// Stacks whose indices and thicknesses stay while the angle changes. What does not depend on the
/// angle is worked out once; layers of one medium share its root, layers of one medium and
/// thickness their phase. Agrees with `stack_amplitudes` to 1e-13 times the number of layers, apart
/// from `doubt`. One object for one thread.
class PreparedStack {
public:
    /// @param stack  its `cos_0` is not read
    explicit PreparedStack(const LaneStack& stack);
    PreparedStack(PreparedStack&&) noexcept;
    PreparedStack& operator=(PreparedStack&&) noexcept;
    PreparedStack(const PreparedStack&) = delete;
    PreparedStack& operator=(const PreparedStack&) = delete;
    ~PreparedStack();

    void power(const Lanes& cos_0, BatchPower& out);
    void respond(const Lanes& cos_0, BatchPower& power, BatchAmplitudes& amplitudes);

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// One angle.
void stack_batch(const LaneStack& stack, BatchPower& power);
void stack_batch(const LaneStack& stack, BatchPower& power, BatchAmplitudes& amplitudes);

/// Reflectance and transmittance as a function of the thickness of one layer only: everything
/// above and below it is folded into a map of its phase, once. Per lane and polarisation, with
/// E = e^{2iδ} = e·e^{iφ} of that layer, r = (a + bE)/(c + dE); stored are the real coefficients of
///     |a + bE|² = n0 + n1 e² + e (n2 cosφ + n3 sinφ),   |c + dE|² likewise,   T = τ e / |c + dE|².
class PhaseMap {
public:
    /// At the angle of the stack.
    /// @param varying  index of the layer whose thickness is free; its `waves` are not read
    PhaseMap(const LaneStack& stack, std::size_t varying);
    PhaseMap(PhaseMap&&) noexcept;
    PhaseMap& operator=(PhaseMap&&) noexcept;
    PhaseMap(const PhaseMap&) = delete;
    PhaseMap& operator=(const PhaseMap&) = delete;
    ~PhaseMap();

    void turn_to(const Lanes& cos_0);

    /// Mean of s and p at `R.size()` equal steps of thickness; both arguments are thickness over
    /// wavelength, ≥ 0. The phase is multiplied on, so that a row costs no trigonometry; its error
    /// grows by one rounding a row.
    /// @pre R.size() == T.size()
    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
               std::span<Lanes> T) const noexcept;
    /// In single precision from the coefficients and phases of the first row on: good to 1e-6, and
    /// 1e-7 more a row.
    void march(const Lanes& first, const Lanes& step, std::span<SingleLanes> R,
               std::span<SingleLanes> T) const noexcept;

    template <class Real>
    struct Coefficients {
        LanesOf<Real> n0, n1, n2, n3, d0, d1, d2, d3, tau;
    };

private:
    struct Work;
    std::unique_ptr<Work> work_;
    Coefficients<double> s_, p_;
    ComplexLanes q_;
};

/// Reflectance and transmittance as a function of a factor on every thickness. Roots and the phases
/// of one step are worked out once; a row then costs only the recursion.
class ScaledStack {
public:
    /// At the angle of the stack.
    explicit ScaledStack(const LaneStack& stack);
    ScaledStack(ScaledStack&&) noexcept;
    ScaledStack& operator=(ScaledStack&&) noexcept;
    ScaledStack(const ScaledStack&) = delete;
    ScaledStack& operator=(const ScaledStack&) = delete;
    ~ScaledStack();

    void turn_to(const Lanes& cos_0);

    /// Mean of s and p at the factors first, first + step, …
    /// @pre R.size() == T.size(), first ≥ 0, step ≥ 0
    void march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const;
    /// In single precision from the roots and phases of the first row on: good to some 1e-6 times
    /// the number of layers, at a resonance times what it enhances a field by.
    void march(double first, double step, std::span<SingleLanes> R, std::span<SingleLanes> T) const;

private:
    std::unique_ptr<detail::AngledStack> stack_;
};

/// Stacks in which some layers are incoherent, as a function of the thickness of one coherent layer
/// or of a factor on all coherent ones; intensities are added as `stack_power` does.
class MixedStack {
public:
    /// At the angle of the stack.
    /// @param varying  coherent layer whose thickness is free; its `waves` are not read
    /// @pre coherent.size() == stack.layers.size()
    MixedStack(const LaneStack& stack, const std::vector<bool>& coherent,
               std::optional<std::size_t> varying);
    MixedStack(MixedStack&&) noexcept;
    MixedStack& operator=(MixedStack&&) noexcept;
    MixedStack(const MixedStack&) = delete;
    MixedStack& operator=(const MixedStack&) = delete;
    ~MixedStack();

    void turn_to(const Lanes& cos_0);

    /// Mean of s and p at the factors first, first + step, … @pre no layer varies alone
    void march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const;
    /// The same at thicknesses over wavelength of the varying layer.
    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R, std::span<Lanes> T) const;

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

}  // namespace nacre::optics
