// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

/// @file
/// Numbers side by side: what stack_batch.h takes and gives.

namespace nacre::optics {

inline constexpr std::size_t kLanes = 32;

template <class Real>
struct alignas(64) LanesOf : std::array<Real, kLanes> {};
using Lanes = LanesOf<double>;
using SingleLanes = LanesOf<float>;

template <class Real>
struct ComplexLanesOf {
    LanesOf<Real> re, im;
};
using ComplexLanes = ComplexLanesOf<double>;

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

/// Ratios of power.
struct LanePower {
    Lanes R, T;
};

struct BatchPower {
    LanePower s, p;
    /// Bound on what double precision loses in R, T, r, t, near a critical angle inside the stack,
    /// in thick layers and at a resonance; where it is too much, take `stack_amplitudes`.
    Lanes doubt;
};

/// Ratios of E at the outer faces.
struct LaneAmplitudes {
    ComplexLanes r, t;
};

struct BatchAmplitudes {
    LaneAmplitudes s, p;
};

}  // namespace nacre::optics
