// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_batch.h"

#include <algorithm>

#include "lane_math.h"

// The algebra is that of coherent_packet.cpp: fields (U, V) from the substrate up, E = e^{2iδ}.

namespace nacre::optics {
namespace {

using lane::C;

NACRE_INLINE C load(const ComplexLanes& lanes, std::size_t i)
{
    return {lanes.re[i], lanes.im[i]};
}
NACRE_INLINE void store(ComplexLanes& lanes, std::size_t i, C value)
{
    lanes.re[i] = value.re;
    lanes.im[i] = value.im;
}

/// Lanes that share Snell's invariant.
struct Frame {
    const Lanes &n_0, &cos_0;

    NACRE_INLINE C q(C n, std::size_t i) const
    {
        const double across = n_0[i] * cos_0[i];
        const double re = (n.re - n_0[i]) * (n.re + n_0[i]) - n.im * n.im + across * across;
        return lane::upper_sqrt({re, 2.0 * n.re * n.im});
    }
};

struct FieldLanes {
    ComplexLanes U, V;
};

NACRE_INLINE void step(FieldLanes& f, std::size_t i, C half_sum, C eta_m, C m_over_eta)
{
    const C U = load(f.U, i), V = load(f.V, i);
    store(f.U, i, U * half_sum + V * eta_m);
    store(f.V, i, V * half_sum + U * m_over_eta);
}

/// Fields of one wave going down in the substrate.
NACRE_INLINE void start(FieldLanes& s, FieldLanes& p, const Frame& frame, const ComplexLanes& below,
                        std::size_t i)
{
    const C n = load(below, i), q = frame.q(n, i);
    store(s.U, i, q);
    store(p.U, i, q * lane::reciprocal(n * n));
    store(s.V, i, {1.0, 0.0});
    store(p.V, i, {1.0, 0.0});
}

struct Fold {
    FieldLanes s, p;
    ComplexLanes passed;
};

NACRE_VECTOR_CLONES void begin_fold(Fold& fold, const LaneStack& stack)
{
    const Frame frame{stack.n_0, stack.cos_0};
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        start(fold.s, fold.p, frame, stack.below, i);
        store(fold.passed, i, {1.0, 0.0});
    }
}

// A layer is worked through in several short loops: one long one would neither fit the registers
// nor let the processor overlap the roots and quotients of one lane with the products of another.

/// What does not depend on the thickness.
NACRE_VECTOR_CLONES void prepare_layer(ScaledStack::Layer& out, const LaneStack& stack,
                                       const LaneLayer& layer)
{
    const Frame frame{stack.n_0, stack.cos_0};
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C n = load(layer.n, i), q = frame.q(n, i), n2 = n * n;
        // 1/q and 1/n² by one quotient.
        const double norm_q = lane::norm(q), norm_n2 = lane::norm(n2);
        const double scale = 1.0 / (norm_q * norm_n2);
        store(out.q, i, q);
        store(out.inverse_q, i, scale * norm_n2 * C{q.re, -q.im});
        store(out.n2, i, n2);
        store(out.inverse_n2, i, scale * norm_q * C{n2.re, -n2.im});
        out.waves[i] = layer.waves[i];
    }
}

/// e^{iδ} of a layer at a factor on its thickness.
NACRE_VECTOR_CLONES void single_trip(const ScaledStack::Layer& layer, double factor,
                                     ComplexLanes& out)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double waves = factor * layer.waves[i];
        const double decay = lane::exp_decay(-2.0 * std::numbers::pi * layer.q.im[i] * waves);
        store(out, i, decay * lane::cis_turns(layer.q.re[i] * waves));
    }
}

/// (1 + E)/2, and (1 − E)/2 times and over q.
struct HalfSums {
    C half_sum, m_times_q, m_over_q;
};
NACRE_INLINE HalfSums half_sums(const ScaledStack::Layer& layer, C half_pass, std::size_t i)
{
    const C E = half_pass * half_pass, m{0.5 - 0.5 * E.re, -0.5 * E.im};
    return {.half_sum = {0.5 + 0.5 * E.re, 0.5 * E.im},
            .m_times_q = m * load(layer.q, i),
            .m_over_q = m * load(layer.inverse_q, i)};
}

/// The fields below a layer become those above it.
NACRE_VECTOR_CLONES void step_fields(FieldLanes& s, FieldLanes& p, ComplexLanes& passed,
                                     const ScaledStack::Layer& layer, const ComplexLanes& phase)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C half_pass = load(phase, i);
        const HalfSums h = half_sums(layer, half_pass, i);
        step(s, i, h.half_sum, h.m_times_q, h.m_over_q);
        step(p, i, h.half_sum, h.m_times_q * load(layer.inverse_n2, i),
             h.m_over_q * load(layer.n2, i));
        store(passed, i, load(passed, i) * half_pass);
    }
}

NACRE_VECTOR_CLONES void turn_on(ComplexLanes& phase, const ComplexLanes& turn)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) store(phase, i, load(phase, i) * load(turn, i));
}

void fold_layer(Fold& fold, const ScaledStack::Layer& prepared)
{
    ComplexLanes phase;
    single_trip(prepared, 1.0, phase);
    step_fields(fold.s, fold.p, fold.passed, prepared, phase);
}

void fold_layer(Fold& fold, const LaneStack& stack, const LaneLayer& layer)
{
    ScaledStack::Layer prepared;
    prepare_layer(prepared, stack, layer);
    fold_layer(fold, prepared);
}

/// Largest effect of a rounding error in a layer: of the phase, 2πq d/λ·ε, and of q² next to a
/// critical angle, n²ε/q² on the admittance.
NACRE_VECTOR_CLONES void add_doubt(Lanes& doubt, const LaneStack& stack, const LaneLayer& layer,
                                   const ScaledStack::Layer& prepared)
{
    constexpr double kEpsilon = 1.1e-16;
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double n2 = lane::norm(load(layer.n, i)) + stack.n_0[i] * stack.n_0[i];
        const double q = std::sqrt(lane::norm(load(prepared.q, i)));
        const double inverse_q = q * lane::norm(load(prepared.inverse_q, i));
        const double phase = 2.0 * std::numbers::pi * layer.waves[i];
        doubt[i] += kEpsilon * (phase * q + (phase + 1.0) * n2 * inverse_q);
    }
}

NACRE_INLINE void finish(LaneResponse& out, std::size_t i, C eta_above, C eta_below, C passed,
                         const FieldLanes& f, C to_E)
{
    const C down = eta_above * load(f.V, i), U = load(f.U, i);
    const C scale = lane::reciprocal(down + U);
    const C r = (down - U) * scale, t = 2.0 * (eta_above * passed * scale);
    store(out.r, i, r);
    store(out.t, i, t * to_E);
    out.R[i] = lane::norm(r);
    out.T[i] = eta_below.re / eta_above.re * lane::norm(t);
}

NACRE_VECTOR_CLONES void finish_fold(BatchResponse& out, const Fold& fold, const LaneStack& stack)
{
    const Frame frame{stack.n_0, stack.cos_0};
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C n_a = load(stack.above, i), q_a = frame.q(n_a, i);
        const C n_b = load(stack.below, i), q_b = frame.q(n_b, i);
        const C n2_a = n_a * n_a, n2_b = n_b * n_b, passed = load(fold.passed, i);
        // 1/n² of both by one quotient.
        const double norm_a = lane::norm(n2_a), norm_b = lane::norm(n2_b);
        const double scale = 1.0 / (norm_a * norm_b);
        const C inverse_n2_a = scale * norm_b * C{n2_a.re, -n2_a.im};
        const C inverse_n2_b = scale * norm_a * C{n2_b.re, -n2_b.im};
        finish(out.s, i, q_a, q_b, passed, fold.s, {1.0, 0.0});
        finish(out.p, i, q_a * inverse_n2_a, q_b * inverse_n2_b, passed, fold.p,
               n_a * n_b * inverse_n2_b);
    }
}

/// Real coefficients of |a + bE|².
struct Modulus {
    double m0, m1, m2, m3;
};
NACRE_INLINE Modulus squared_modulus(C a, C b)
{
    return {lane::norm(a), lane::norm(b), 2.0 * (a.re * b.re + a.im * b.im),
            -2.0 * (a.re * b.im - a.im * b.re)};
}

/// The waves that go down and up inside the varying layer, (η, 1) and (η, −1), carried to the
/// surface, and their strengths α = (U + ηV)/2, β = (U − ηV)/2 from the fields below.
struct Split {
    FieldLanes down, up;
    ComplexLanes alpha, beta, eta;
};

NACRE_INLINE void split(Split& out, const FieldLanes& below, std::size_t i, C eta)
{
    const C U = load(below.U, i), eta_V = eta * load(below.V, i);
    store(out.alpha, i, 0.5 * (U + eta_V));
    store(out.beta, i, 0.5 * (U - eta_V));
    store(out.eta, i, eta);
    store(out.down.U, i, eta);
    store(out.down.V, i, {1.0, 0.0});
    store(out.up.U, i, eta);
    store(out.up.V, i, {-1.0, 0.0});
}

NACRE_VECTOR_CLONES void split_fields(Split& s, Split& p, ComplexLanes& q_out, const Fold& fold,
                                      const LaneStack& stack, const LaneLayer& layer)
{
    const Frame frame{stack.n_0, stack.cos_0};
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C n = load(layer.n, i), q = frame.q(n, i);
        store(q_out, i, q);
        split(s, fold.s, i, q);
        split(p, fold.p, i, q * lane::reciprocal(n * n));
    }
}

void carry_up(Split& s, Split& p, ComplexLanes& passed, const LaneStack& stack,
              const LaneLayer& layer)
{
    ScaledStack::Layer prepared;
    ComplexLanes phase, already_counted = passed;
    prepare_layer(prepared, stack, layer);
    single_trip(prepared, 1.0, phase);
    step_fields(s.down, p.down, passed, prepared, phase);
    step_fields(s.up, p.up, already_counted, prepared, phase);
}

NACRE_INLINE void coefficients(PhaseMap::Coefficients& out, const Split& split, std::size_t i,
                               C eta_above, C eta_below, C passed)
{
    const C alpha = load(split.alpha, i), beta = load(split.beta, i);
    const C down = eta_above * load(split.down.V, i), up = eta_above * load(split.up.V, i);
    const C down_U = load(split.down.U, i), up_U = load(split.up.U, i);
    const Modulus d = squared_modulus(alpha * (down + down_U), beta * (up + up_U));
    const Modulus n = squared_modulus(alpha * (down - down_U), beta * (up - up_U));
    const double scale = 1.0 / (d.m0 + d.m1);
    out.n0[i] = n.m0 * scale;
    out.n1[i] = n.m1 * scale;
    out.n2[i] = n.m2 * scale;
    out.n3[i] = n.m3 * scale;
    out.d0[i] = d.m0 * scale;
    out.d1[i] = d.m1 * scale;
    out.d2[i] = d.m2 * scale;
    out.d3[i] = d.m3 * scale;
    out.tau[i] = 4.0 * scale * eta_below.re * eta_above.re * lane::norm(load(split.eta, i)) *
                 lane::norm(passed);
}

NACRE_VECTOR_CLONES void finish_map(PhaseMap::Coefficients& s_out, PhaseMap::Coefficients& p_out,
                                    const Split& s, const Split& p, const ComplexLanes& passed,
                                    const LaneStack& stack)
{
    const Frame frame{stack.n_0, stack.cos_0};
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C n_a = load(stack.above, i), q_a = frame.q(n_a, i);
        const C n_b = load(stack.below, i), q_b = frame.q(n_b, i);
        const C pass = load(passed, i);
        coefficients(s_out, s, i, q_a, q_b, pass);
        coefficients(p_out, p, i, q_a * lane::reciprocal(n_a * n_a),
                     q_b * lane::reciprocal(n_b * n_b), pass);
    }
}

/// One row, and the phase on to the next.
NACRE_VECTOR_CLONES void map_row(const PhaseMap::Coefficients& s, const PhaseMap::Coefficients& p,
                                 ComplexLanes& phase, const ComplexLanes& turn, Lanes& R, Lanes& T)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const C E = load(phase, i);
        const double e2 = lane::norm(E);
        const double n_s = s.n0[i] + s.n1[i] * e2 + s.n2[i] * E.re + s.n3[i] * E.im;
        const double d_s = s.d0[i] + s.d1[i] * e2 + s.d2[i] * E.re + s.d3[i] * E.im;
        const double n_p = p.n0[i] + p.n1[i] * e2 + p.n2[i] * E.re + p.n3[i] * E.im;
        const double d_p = p.d0[i] + p.d1[i] * e2 + p.d2[i] * E.re + p.d3[i] * E.im;
        const double half = 0.5 / (d_s * d_p);
        R[i] = half * (n_s * d_p + n_p * d_s);
        T[i] = half * std::sqrt(e2) * (s.tau[i] * d_p + p.tau[i] * d_s);
        store(phase, i, E * load(turn, i));
    }
}

/// E = e^{2iδ} of a layer.
NACRE_VECTOR_CLONES void round_trip(const ComplexLanes& q, const Lanes& waves, ComplexLanes& out)
{
#pragma GCC ivdep
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double e = lane::exp_decay(-4.0 * std::numbers::pi * q.im[i] * waves[i]);
        store(out, i, e * lane::cis_turns(2.0 * q.re[i] * waves[i]));
    }
}

}  // namespace

void stack_batch(const LaneStack& stack, BatchResponse& response) noexcept
{
    Fold fold;
    begin_fold(fold, stack);
    response.doubt.fill(0.0);
    ScaledStack::Layer prepared;
    for (auto layer = stack.layers.rbegin(); layer != stack.layers.rend(); ++layer) {
        prepare_layer(prepared, stack, *layer);
        fold_layer(fold, prepared);
        add_doubt(response.doubt, stack, *layer, prepared);
    }
    finish_fold(response, fold, stack);
}

PhaseMap::PhaseMap(const LaneStack& stack, std::size_t varying) noexcept
{
    Fold fold;
    begin_fold(fold, stack);
    for (std::size_t j = stack.layers.size(); j-- > varying + 1;)
        fold_layer(fold, stack, stack.layers[j]);
    Split s, p;
    split_fields(s, p, q_, fold, stack, stack.layers[varying]);
    for (std::size_t j = varying; j-- > 0;) carry_up(s, p, fold.passed, stack, stack.layers[j]);
    finish_map(s_, p_, s, p, fold.passed, stack);
}

void PhaseMap::march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                     std::span<Lanes> T) const noexcept
{
    ComplexLanes phase, turn;
    round_trip(q_, first, phase);
    round_trip(q_, step, turn);
    for (std::size_t row = 0; row < R.size(); ++row) map_row(s_, p_, phase, turn, R[row], T[row]);
}

ScaledStack::ScaledStack(const LaneStack& stack)
    : ends_{.n_0 = stack.n_0,
            .cos_0 = stack.cos_0,
            .above = stack.above,
            .below = stack.below,
            .layers = {}},
      layers_(stack.layers.size())
{
    for (std::size_t j = 0; j < layers_.size(); ++j)
        prepare_layer(layers_[j], stack, stack.layers[j]);
}

void ScaledStack::march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const
{
    std::vector<ComplexLanes> phase(layers_.size()), turn(layers_.size());
    for (std::size_t j = 0; j < layers_.size(); ++j) {
        single_trip(layers_[j], first, phase[j]);
        single_trip(layers_[j], step, turn[j]);
    }
    Fold ground, fold;
    begin_fold(ground, ends_);
    BatchResponse response;
    for (std::size_t row = 0; row < R.size(); ++row) {
        fold = ground;
        for (std::size_t j = layers_.size(); j-- > 0;) {
            step_fields(fold.s, fold.p, fold.passed, layers_[j], phase[j]);
            turn_on(phase[j], turn[j]);
        }
        finish_fold(response, fold, ends_);
        for (std::size_t i = 0; i < kLanes; ++i) {
            R[row][i] = 0.5 * (response.s.R[i] + response.p.R[i]);
            T[row][i] = 0.5 * (response.s.T[i] + response.p.T[i]);
        }
    }
}

}  // namespace nacre::optics
