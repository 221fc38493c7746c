// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/optics/lanes.h"

/// @file
/// The two waves in every medium of 32 stacks, carried from the substrate up.
///
/// With q = n cosθ and waves a (down) and b (up) at the top of a medium,
///     s: E = a + b, H = q (a − b);    p: H = a + b, E = (q/n²)(a − b).
/// Both are continuous, so that across an interface (1 above 2), times 2q₁,
///     s: a₁, b₁ = q₁(a₂ + b₂) ± q₂(a₂ − b₂);    p: the same with q₂ n₁²/n₂².
/// Through a layer b gains E = e^{2iδ} and both leave behind e^{−iδ}. Nothing is ever divided: r is
/// b/a at the top, t is the product of all 2q₁ and e^{iδ} over a.

namespace nacre::optics::detail {

[[nodiscard]] SingleLanes in_single(const Lanes& lanes);
[[nodiscard]] ComplexLanesOf<float> in_single(const ComplexLanes& lanes);

/// What a medium brings that does not depend on the angle.
struct LaneMedium {
    ComplexLanes excess;  ///< n² − n_0²
    Lanes weight;         ///< |n|² + n_0²
};

/// A medium at an angle.
struct LaneRoot {
    ComplexLanes q;
    Lanes doubt, doubt_per_wave;  ///< of a rounding in q² and in the phase
};

/// One passage through a layer at an angle.
template <class Real>
struct TripOf {
    ComplexLanesOf<Real> E;  ///< e^{2iδ}
    LanesOf<Real> share;     ///< |E|, what is left of a power
};
using LaneTrip = TripOf<double>;

template <class Real>
struct WavesOf {
    ComplexLanesOf<Real> a, b;
};
using Waves = WavesOf<double>;

/// Waves of both polarisations, and what |t|² gathers on the way: the product of all |2q₁ e^{iδ}|².
template <class Real>
struct FieldsOf {
    WavesOf<Real> s, p;
    LanesOf<Real> passed_s, passed_p;
    /// Least `passed` at a wave of about 1 anywhere in the stack: |t|² over it is how much
    /// stronger than outside the field is there.
    LanesOf<Real> least_s, least_p;
};
using LaneFields = FieldsOf<double>;

void prepare_medium(LaneMedium& out, const ComplexLanes& n, const Lanes& n_0);
/// n₁²/n₂².
void prepare_interface(ComplexLanes& ratio, const ComplexLanes& n_1, const ComplexLanes& n_2);

void find_root(LaneRoot& out, const LaneMedium& medium, const Lanes& n_0, const Lanes& cos_0);
/// Of the ambient itself, n_0: what no angle changes, and the rest.
void prepare_ambient_root(LaneRoot& out);
void find_ambient_root(LaneRoot& out, const Lanes& n_0, const Lanes& cos_0);
/// At `factor` times the thickness over wavelength.
void find_trip(LaneTrip& out, const LaneRoot& root, const Lanes& waves, double factor);
/// e^{iδ}, which only amplitudes need.
void find_half_trip(ComplexLanes& out, const LaneRoot& root, const Lanes& waves);
/// The trip of the sum of two thicknesses.
void add_trip(LaneTrip& trip, const LaneTrip& more);
void add_trip(TripOf<float>& trip, const TripOf<float>& more);

/// All layers of one medium: how many, and their thickness over wavelength.
struct MediumLoad {
    double layers = 0.0;
    Lanes waves;
};
/// The doubt of one medium.
void set_doubt(Lanes& out, const LaneRoot& root, const MediumLoad& load);
/// Adds to the sum of the doubts of all media and to that of their squares.
void add_doubt(Lanes& sum, Lanes& squares, const LaneRoot& root, const MediumLoad& load);
/// Layers of one medium share their roundings, those of different media do not: with many media
/// three times the root of the squares is a bound that holds as well as the sum.
void limit_doubt(Lanes& sum, const Lanes& squares);

/// An interface and the passage through what lies above it.
template <class Real>
struct CrossingOf {
    const ComplexLanesOf<Real>*q_1, *q_2, *ratio;
    const TripOf<Real>* trip;
};
using Crossing = CrossingOf<double>;
/// What is above the first crossing if below the last one a wave of strength 1 goes down.
void carry_down_wave(LaneFields& fields, const std::vector<Crossing>& crossings);
void carry_down_wave(FieldsOf<float>& fields, const std::vector<CrossingOf<float>>& crossings);
/// The same, and for one that goes up; both scaled alike.
void carry_both_waves(LaneFields& down, LaneFields& up, const std::vector<Crossing>& crossings);

/// Direction of the product of all 2q₁ e^{iδ}, of modulus 1; 0 where it underflows.
/// @param half_trips  above each crossing; null where nothing is passed through
void gather_phase(ComplexLanes& out, const std::vector<Crossing>& crossings,
                  const std::vector<const ComplexLanes*>& half_trips);

/// Ends of a stack at an angle.
struct LaneEnds {
    const ComplexLanes *n_above, *n_below, *q_above, *q_below;
    const ComplexLanes *over_square_above, *over_square_below;  ///< 1/n²
};
/// @param doubt  multiplied by the enhancement of the field: a resonance enlarges errors of phase
void finish_power(LanePower& s, LanePower& p, Lanes& doubt, const LaneFields& fields,
                  const LaneEnds& ends);
/// Of R and T of the mean of both polarisations: Re η below over twice that above.
struct MeanScales {
    Lanes s, p;
};
void find_mean_scales(MeanScales& out, const LaneEnds& ends);
void finish_mean(SingleLanes& R, SingleLanes& T, const FieldsOf<float>& fields,
                 const SingleLanes& scale_s, const SingleLanes& scale_p);
/// @param phase  of gather_phase()
void finish_amplitudes(LaneAmplitudes& s, LaneAmplitudes& p, const LaneFields& fields,
                       const ComplexLanes& phase, const LaneEnds& ends);

}  // namespace nacre::optics::detail
