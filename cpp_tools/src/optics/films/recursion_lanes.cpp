// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "films/recursion_lanes.h"

#include "nacre/core/vector_clones.h"
#include "nacre/optics/fresnel.h"

namespace nacre::optics::detail {
namespace {

Complex at(const ComplexLanes& lanes, std::size_t i)
{
    return {lanes.re[i], lanes.im[i]};
}

void set(ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

/// γ ← (r + γE²)/(1 + rγE²) across one interface and the layer below it; `both` gathers the squared
/// moduli of the denominators.
NACRE_VECTOR_CLONES void climb(const ComplexLanes& r, const ComplexLanes& E, ComplexLanes& gamma,
                               Lanes& both)
{
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double re = gamma.re[i] * E.re[i] - gamma.im[i] * E.im[i];
        const double im = gamma.re[i] * E.im[i] + gamma.im[i] * E.re[i];
        const double below_re = 1.0 + r.re[i] * re - r.im[i] * im;
        const double below_im = r.re[i] * im + r.im[i] * re;
        const double norm = below_re * below_re + below_im * below_im;
        const double up_re = r.re[i] + re, up_im = r.im[i] + im;
        gamma.re[i] = (up_re * below_re + up_im * below_im) / norm;
        gamma.im[i] = (up_im * below_re - up_re * below_im) / norm;
        both[i] *= norm;
    }
}

void add_half(const RecursionLanes::Faces& faces, std::span<const LaneTrip> trips, Lanes& R,
              Lanes& T)
{
    ComplexLanes gamma = faces.r.back();
    Lanes both, passed = faces.passed;
    both.fill(1.0);
    for (std::size_t j = trips.size(); j-- > 0;) {
        climb(faces.r[j], trips[j].E, gamma, both);
        for (std::size_t i = 0; i < kLanes; ++i) passed[i] *= trips[j].share[i];
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        R[i] += 0.5 * (gamma.re[i] * gamma.re[i] + gamma.im[i] * gamma.im[i]);
        T[i] += 0.5 * passed[i] / both[i];
    }
}

}  // namespace

RecursionLanes::RecursionLanes(const LaneStack& stack, std::optional<std::size_t> varying)
    : stack_(stack), varying_(varying.value_or(0)), roots_(stack.layers.size())
{
    s_.r.resize(stack.layers.size() + 1);
    p_.r.resize(stack.layers.size() + 1);
    turn_to(stack.cos_0);
}

void RecursionLanes::turn_to(const Lanes& cos_0)
{
    for (std::size_t i = 0; i < kLanes; ++i) turn_lane(i, cos_0[i]);
}

void RecursionLanes::turn_lane(std::size_t lane, double cos_0)
{
    const Complex n_0 = stack_.n_0[lane];
    Complex above = at(stack_.above, lane), cos_above = forward_cosine(n_0, above, cos_0);
    const double flux_s = (above * cos_above).real();
    const double flux_p = (std::conj(above) * cos_above).real();
    double passed_s = 1.0, passed_p = 1.0;
    for (std::size_t j = 0; j <= stack_.layers.size(); ++j) {
        const bool last = j == stack_.layers.size();
        const Complex below = at(last ? stack_.below : stack_.layers[j].n, lane);
        const Complex cos_below = forward_cosine(n_0, below, cos_0);
        const auto face = fresnel_amplitudes(above, below, cos_above, cos_below);
        set(s_.r[j], lane, face.r_s);
        set(p_.r[j], lane, face.r_p);
        passed_s *= std::norm(face.t_s);
        passed_p *= std::norm(face.t_p);
        if (!last) set(roots_[j].q, lane, below * cos_below);
        above = below;
        cos_above = cos_below;
    }
    // The flux of s goes with N cosθ, that of p with N* cosθ.
    s_.passed[lane] = passed_s * (above * cos_above).real() / flux_s;
    p_.passed[lane] = passed_p * (std::conj(above) * cos_above).real() / flux_p;
}

void RecursionLanes::march_trips(std::vector<LaneTrip>& trips, std::span<const LaneTrip> steps,
                                 std::size_t first_moving, std::span<Lanes> R,
                                 std::span<Lanes> T) const
{
    for (std::size_t row = 0; row < R.size(); ++row) {
        R[row].fill(0.0);
        T[row].fill(0.0);
        add_half(s_, trips, R[row], T[row]);
        add_half(p_, trips, R[row], T[row]);
        for (std::size_t j = 0; j < steps.size(); ++j) add_trip(trips[first_moving + j], steps[j]);
    }
}

void RecursionLanes::march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                           std::span<Lanes> T) const
{
    std::vector<LaneTrip> trips(roots_.size());
    for (std::size_t j = 0; j < trips.size(); ++j)
        find_trip(trips[j], roots_[j], j == varying_ ? first : stack_.layers[j].waves, 1.0);
    LaneTrip more;
    find_trip(more, roots_[varying_], step, 1.0);
    march_trips(trips, {&more, 1}, varying_, R, T);
}

void RecursionLanes::march_all(double first, double step, std::span<Lanes> R,
                               std::span<Lanes> T) const
{
    std::vector<LaneTrip> trips(roots_.size()), steps(roots_.size());
    for (std::size_t j = 0; j < trips.size(); ++j) {
        find_trip(trips[j], roots_[j], stack_.layers[j].waves, first);
        find_trip(steps[j], roots_[j], stack_.layers[j].waves, step);
    }
    march_trips(trips, steps, 0, R, T);
}

}  // namespace nacre::optics::detail
