// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/angled_stack.h"
#include "lanes/simd.h"
#include "nacre/optics/stack_batch.h"

namespace nacre::optics {
namespace {

using detail::AngledStack;
using detail::Crossing;
using detail::in_single;
using detail::LaneFields;
using detail::LaneTrip;
using detail::Waves;
using simd::C;
using simd::kWidth;
using simd::load;
using simd::store;
using simd::V;

/// Real coefficients of |a + bE|².
struct Modulus {
    V m0, m1, m2, m3;
};
NACRE_INLINE Modulus squared_modulus(C a, C b)
{
    return {simd::norm(a), simd::norm(b), 2.0 * (a.re * b.re + a.im * b.im),
            -2.0 * (a.re * b.im - a.im * b.re)};
}

NACRE_INLINE void put(PhaseMap::Coefficients<double>& out, std::size_t i, const Modulus& n,
                      const Modulus& d, V tau)
{
    const V scale = 1.0 / (d.m0 + d.m1);
    store(out.n0, i, n.m0 * scale);
    store(out.n1, i, n.m1 * scale);
    store(out.n2, i, n.m2 * scale);
    store(out.n3, i, n.m3 * scale);
    store(out.d0, i, d.m0 * scale);
    store(out.d1, i, d.m1 * scale);
    store(out.d2, i, d.m2 * scale);
    store(out.d3, i, d.m3 * scale);
    store(out.tau, i, tau * scale);
}

/// @param passed  |product of 2q₁ and e^{iδ}|² of all but the varying layer, with Re η below /
/// above
NACRE_INLINE void coefficients(PhaseMap::Coefficients<double>& out, std::size_t i,
                               const Waves& below, const Waves& down, const Waves& up, V passed)
{
    const C alpha = load(below.a, i), beta = load(below.b, i);
    put(out, i, squared_modulus(alpha * load(down.b, i), beta * load(up.b, i)),
        squared_modulus(alpha * load(down.a, i), beta * load(up.a, i)), passed);
}

NACRE_VECTOR_CLONES void finish_map(PhaseMap::Coefficients<double>& s_out,
                                    PhaseMap::Coefficients<double>& p_out, const LaneFields& below,
                                    const LaneFields& down, const LaneFields& up,
                                    const detail::LaneEnds& ends)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C q_a = load(*ends.q_above, i), q_b = load(*ends.q_below, i);
        const C eta_a = q_a * load(*ends.over_square_above, i);
        const C eta_b = q_b * load(*ends.over_square_below, i);
        const V passed_s = load(below.passed_s, i) * load(down.passed_s, i) * q_b.re / q_a.re;
        const V passed_p = load(below.passed_p, i) * load(down.passed_p, i) * eta_b.re / eta_a.re;
        coefficients(s_out, i, below.s, down.s, up.s, passed_s);
        coefficients(p_out, i, below.p, down.p, up.p, passed_p);
    }
}

/// One row, and the phase on to the next.
template <class Real>
NACRE_INLINE void row_of(const PhaseMap::Coefficients<Real>& s,
                         const PhaseMap::Coefficients<Real>& p, ComplexLanesOf<Real>& phase,
                         const ComplexLanesOf<Real>& turn, LanesOf<Real>& R, LanesOf<Real>& T)
{
    using Lanes = LanesOf<Real>;
    using Vector = simd::Vector<Real>;
    for (std::size_t i = 0; i < kLanes; i += simd::kWidthOf<Real>) {
        const simd::Complex<Real> E = load(phase, i);
        const Vector e2 = simd::norm(E);
        const auto form = [&](const Lanes& c0, const Lanes& c1, const Lanes& c2, const Lanes& c3)
            __attribute__((always_inline))
        {
            return load(c0, i) + load(c1, i) * e2 + load(c2, i) * E.re + load(c3, i) * E.im;
        };
        const Vector n_s = form(s.n0, s.n1, s.n2, s.n3), d_s = form(s.d0, s.d1, s.d2, s.d3);
        const Vector n_p = form(p.n0, p.n1, p.n2, p.n3), d_p = form(p.d0, p.d1, p.d2, p.d3);
        // At grazing incidence and in resonance, or without a film, both are 0 but for rounding.
        const Vector product = d_s * d_p, one = Vector{} + Real{1};
        const Vector half = Real{0.5} / (product > 0 ? product : one);
        store(R, i, half * (n_s * d_p + n_p * d_s));
        store(T, i, half * simd::square_root(e2) * (load(s.tau, i) * d_p + load(p.tau, i) * d_s));
        store(phase, i, E * load(turn, i));
    }
}
NACRE_VECTOR_CLONES void map_row(const PhaseMap::Coefficients<double>& s,
                                 const PhaseMap::Coefficients<double>& p, ComplexLanes& phase,
                                 const ComplexLanes& turn, Lanes& R, Lanes& T)
{
    row_of(s, p, phase, turn, R, T);
}
NACRE_VECTOR_CLONES void map_row(const PhaseMap::Coefficients<float>& s,
                                 const PhaseMap::Coefficients<float>& p,
                                 ComplexLanesOf<float>& phase, const ComplexLanesOf<float>& turn,
                                 SingleLanes& R, SingleLanes& T)
{
    row_of(s, p, phase, turn, R, T);
}

PhaseMap::Coefficients<float> in_single(const PhaseMap::Coefficients<double>& c)
{
    using detail::in_single;
    return {.n0 = in_single(c.n0),
            .n1 = in_single(c.n1),
            .n2 = in_single(c.n2),
            .n3 = in_single(c.n3),
            .d0 = in_single(c.d0),
            .d1 = in_single(c.d1),
            .d2 = in_single(c.d2),
            .d3 = in_single(c.d3),
            .tau = in_single(c.tau)};
}

/// E = e^{2iδ} of a layer.
NACRE_VECTOR_CLONES void round_trip(const ComplexLanes& root, const Lanes& waves, ComplexLanes& out)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C q = load(root, i);
        const V wave = 2.0 * load(waves, i);
        store(out, i,
              simd::exp_decay((-2.0 * std::numbers::pi) * q.im * wave) *
                  simd::cis_turns(q.re * wave));
    }
}

}  // namespace

struct PhaseMap::Work {
    AngledStack stack;
    std::size_t varying;
    std::vector<LaneTrip> trips;
    std::vector<Crossing> above, below;
    LaneFields from_below;  ///< one wave below the varying layer
    LaneFields down, up;    ///< both waves of the varying layer

    Work(const LaneStack& lanes, std::size_t layer) : stack(lanes), varying(layer)
    {
        stack.find_trips(trips, 0.0);
        above = stack.crossings(trips, 0, varying + 1);
        below = stack.crossings(trips, varying + 1, stack.layers() + 1);
    }
};

PhaseMap::PhaseMap(const LaneStack& stack, std::size_t varying)
    : work_(std::make_unique<Work>(stack, varying))
{
    turn_to(stack.cos_0);
}
PhaseMap::PhaseMap(PhaseMap&&) noexcept = default;
PhaseMap& PhaseMap::operator=(PhaseMap&&) noexcept = default;
PhaseMap::~PhaseMap() = default;

void PhaseMap::turn_to(const Lanes& cos_0)
{
    Work& work = *work_;
    work.stack.turn_to(cos_0);
    work.stack.find_trips(work.trips, 1.0);
    q_ = work.stack.q(work.varying + 1);
    carry_down_wave(work.from_below, work.below);
    carry_both_waves(work.down, work.up, work.above);
    finish_map(s_, p_, work.from_below, work.down, work.up, work.stack.ends());
}

void PhaseMap::march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                     std::span<Lanes> T) const noexcept
{
    ComplexLanes phase, turn;
    round_trip(q_, first, phase);
    round_trip(q_, step, turn);
    for (std::size_t row = 0; row < R.size(); ++row) map_row(s_, p_, phase, turn, R[row], T[row]);
}

void PhaseMap::march(const Lanes& first, const Lanes& step, std::span<SingleLanes> R,
                     std::span<SingleLanes> T) const noexcept
{
    ComplexLanes phase, turn;
    round_trip(q_, first, phase);
    round_trip(q_, step, turn);
    const Coefficients<float> s = in_single(s_), p = in_single(p_);
    ComplexLanesOf<float> single_phase = in_single(phase), single_turn = in_single(turn);
    for (std::size_t row = 0; row < R.size(); ++row)
        map_row(s, p, single_phase, single_turn, R[row], T[row]);
}

}  // namespace nacre::optics
