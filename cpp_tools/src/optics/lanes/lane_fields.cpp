// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/lane_fields.h"

#include <array>

#include "lanes/simd.h"

namespace nacre::optics::detail {
namespace {

using simd::C;
using simd::kWidth;
using simd::load;
using simd::store;
using simd::V;

/// 64 layers between indices of 1e6 and 1e-6 stay within a double's range in steps of this many.
/// A resonance between two of them still shows. A float holds less.
template <class Real>
constexpr std::size_t kNormaliseEvery = sizeof(Real) == sizeof(double) ? 4 : 1;
/// Above any power; over it no power becomes subnormal, which costs a hundred cycles.
template <class Real>
constexpr Real kLarge = sizeof(Real) == sizeof(double) ? Real(1e100) : Real(1e30);

/// Waves of one polarisation in registers.
template <class Real, std::size_t Count>
struct Registers {
    using Vector = simd::Vector<Real>;
    using Complex = simd::Complex<Real>;

    std::array<Complex, Count> a, b;
    Vector passed = Vector{} + Real{1}, least = Vector{} + kLarge<Real>;

    NACRE_INLINE void cross(Complex q_1, Complex q_2)
    {
        for (std::size_t w = 0; w < Count; ++w) {
            const Complex x = q_1 * (a[w] + b[w]), y = q_2 * (a[w] - b[w]);
            a[w] = x + y;
            b[w] = x - y;
        }
    }
    NACRE_INLINE void pass(Vector through, Complex E)
    {
        for (Complex& up : b) up = up * E;
        passed = passed * through;
    }
    /// Products of many q would overflow. Waves that belong together keep their ratios.
    NACRE_INLINE void normalise()
    {
        Vector size{};
        for (const Complex& down : a) size += simd::absolute(down.re) + simd::absolute(down.im);
        const Vector scale = Real{1} / size;
        for (std::size_t w = 0; w < Count; ++w) {
            a[w] = scale * a[w];
            b[w] = scale * b[w];
        }
        passed = passed * scale * scale;
        least = passed < least ? passed : least;
    }
};

/// The first goes down, the second up.
template <class Real, std::size_t Count>
NACRE_INLINE Registers<Real, Count> one_wave_each()
{
    Registers<Real, Count> waves;
    constexpr simd::Vector<Real> zero{};
    for (std::size_t w = 0; w < Count; ++w) {
        waves.a[w] = {zero + (w == 0 ? Real{1} : Real{0}), zero};
        waves.b[w] = {zero + (w == 0 ? Real{0} : Real{1}), zero};
    }
    return waves;
}

template <class Real, std::size_t Count>
NACRE_INLINE void carry(const std::array<FieldsOf<Real>*, Count>& fields,
                        const std::vector<CrossingOf<Real>>& crossings)
{
    for (std::size_t i = 0; i < kLanes; i += simd::kWidthOf<Real>) {
        auto s = one_wave_each<Real, Count>(), p = s;
        for (std::size_t j = crossings.size(); j-- > 0;) {
            const CrossingOf<Real>& crossing = crossings[j];
            const simd::Complex<Real> q_1 = load(*crossing.q_1, i), q_2 = load(*crossing.q_2, i);
            s.cross(q_1, q_2);
            p.cross(q_1, q_2 * load(*crossing.ratio, i));
            const simd::Complex<Real> E = load(crossing.trip->E, i);
            const simd::Vector<Real> through =
                Real{4} * simd::norm(q_1) * load(crossing.trip->share, i);
            s.pass(through, E);
            p.pass(through, E);
            if (j % kNormaliseEvery<Real> == kNormaliseEvery<Real> - 1) {
                s.normalise();
                p.normalise();
            }
        }
        store(fields[0]->least_s, i, s.least);
        store(fields[0]->least_p, i, p.least);
        store(fields[0]->passed_s, i, s.passed);
        store(fields[0]->passed_p, i, p.passed);
        for (std::size_t w = 0; w < Count; ++w) {
            store(fields[w]->s.a, i, s.a[w]);
            store(fields[w]->s.b, i, s.b[w]);
            store(fields[w]->p.a, i, p.a[w]);
            store(fields[w]->p.b, i, p.b[w]);
        }
    }
}

template <class Real>
NACRE_INLINE void multiply_trips(TripOf<Real>& trip, const TripOf<Real>& more)
{
    for (std::size_t i = 0; i < kLanes; i += simd::kWidthOf<Real>) {
        store(trip.E, i, load(trip.E, i) * load(more.E, i));
        store(trip.share, i, load(trip.share, i) * load(more.share, i));
    }
}

/// Re(q/n²), the admittance of p.
NACRE_INLINE V tilted(C q, C over_square)
{
    return q.re * over_square.re - q.im * over_square.im;
}

}  // namespace

SingleLanes in_single(const Lanes& lanes)
{
    SingleLanes result;
    for (std::size_t i = 0; i < kLanes; ++i) result[i] = static_cast<float>(lanes[i]);
    return result;
}
ComplexLanesOf<float> in_single(const ComplexLanes& lanes)
{
    return {in_single(lanes.re), in_single(lanes.im)};
}

NACRE_VECTOR_CLONES void prepare_medium(LaneMedium& out, const ComplexLanes& n, const Lanes& n_0)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C index = load(n, i);
        const V ambient = load(n_0, i);
        store(out.excess, i,
              {(index.re - ambient) * (index.re + ambient) - index.im * index.im,
               2.0 * index.re * index.im});
        store(out.weight, i, simd::norm(index) + ambient * ambient);
    }
}

NACRE_VECTOR_CLONES void prepare_interface(ComplexLanes& ratio, const ComplexLanes& n_1,
                                           const ComplexLanes& n_2)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C quotient = load(n_1, i) * simd::reciprocal(load(n_2, i));
        store(ratio, i, quotient * quotient);
    }
}

NACRE_VECTOR_CLONES void find_root(LaneRoot& out, const LaneMedium& medium, const Lanes& n_0,
                                   const Lanes& cos_0)
{
    constexpr double kEpsilon = 1.1e-16;
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const V across = load(n_0, i) * load(cos_0, i);
        const C excess = load(medium.excess, i);
        const auto root = simd::upper_root({excess.re + across * across, excess.im});
        store(out.q, i, root.value);
        // n²ε/q² on the admittance, 2πq d/λ·ε on the phase and again the error of q in it.
        const V of_q = load(medium.weight, i) * root.inverse;
        store(out.doubt, i, kEpsilon * of_q);
        store(out.doubt_per_wave, i,
              (2.0 * std::numbers::pi * kEpsilon) * (1.5 * root.largest + of_q));
    }
}

void prepare_ambient_root(LaneRoot& out)
{
    out.q.im.fill(0.0);
    out.doubt.fill(0.0);  // no error is made
    out.doubt_per_wave.fill(2.0 * std::numbers::pi * 1.1e-16);
}

NACRE_VECTOR_CLONES void find_ambient_root(LaneRoot& out, const Lanes& n_0, const Lanes& cos_0)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth)
        store(out.q.re, i, load(n_0, i) * load(cos_0, i));
}

NACRE_VECTOR_CLONES void find_trip(LaneTrip& out, const LaneRoot& root, const Lanes& waves,
                                   double factor)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const V wave = factor * load(waves, i);
        const C q = load(root.q, i);
        const C turn = simd::cis_turns(2.0 * q.re * wave);
        if (simd::all_zero(q.im)) {
            store(out.E, i, turn);
            store(out.share, i, V{} + 1.0);
            continue;
        }
        const V decay = simd::exp_decay((-4.0 * std::numbers::pi) * q.im * wave);
        store(out.E, i, decay * turn);
        store(out.share, i, decay);
    }
}

NACRE_VECTOR_CLONES void find_half_trip(ComplexLanes& out, const LaneRoot& root, const Lanes& waves)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const V wave = load(waves, i);
        const C q = load(root.q, i);
        store(out, i,
              simd::exp_decay((-2.0 * std::numbers::pi) * q.im * wave) *
                  simd::cis_turns(q.re * wave));
    }
}

NACRE_VECTOR_CLONES void add_trip(LaneTrip& trip, const LaneTrip& more)
{
    multiply_trips(trip, more);
}
NACRE_VECTOR_CLONES void add_trip(TripOf<float>& trip, const TripOf<float>& more)
{
    multiply_trips(trip, more);
}

NACRE_VECTOR_CLONES void set_doubt(Lanes& out, const LaneRoot& root, const MediumLoad& medium)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth)
        store(out, i,
              medium.layers * load(root.doubt, i) +
                  load(medium.waves, i) * load(root.doubt_per_wave, i));
}

NACRE_VECTOR_CLONES void add_doubt(Lanes& sum, Lanes& squares, const LaneRoot& root,
                                   const MediumLoad& medium)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const V doubt = medium.layers * load(root.doubt, i) +
                        load(medium.waves, i) * load(root.doubt_per_wave, i);
        store(sum, i, load(sum, i) + doubt);
        store(squares, i, load(squares, i) + doubt * doubt);
    }
}

NACRE_VECTOR_CLONES void limit_doubt(Lanes& sum, const Lanes& squares)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const V all = load(sum, i), typical = 3.0 * simd::square_root(load(squares, i));
        store(sum, i, typical < all ? typical : all);
    }
}

NACRE_VECTOR_CLONES void carry_down_wave(LaneFields& fields, const std::vector<Crossing>& crossings)
{
    carry<double, 1>({&fields}, crossings);
}
NACRE_VECTOR_CLONES void carry_down_wave(FieldsOf<float>& fields,
                                         const std::vector<CrossingOf<float>>& crossings)
{
    carry<float, 1>({&fields}, crossings);
}

NACRE_VECTOR_CLONES void carry_both_waves(LaneFields& down, LaneFields& up,
                                          const std::vector<Crossing>& crossings)
{
    carry<double, 2>({&down, &up}, crossings);
}

NACRE_VECTOR_CLONES void finish_power(LanePower& s, LanePower& p, Lanes& doubt,
                                      const LaneFields& fields, const LaneEnds& ends)
{
    constexpr double kNotZero = 1e-300;
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C q_above = load(*ends.q_above, i), q_below = load(*ends.q_below, i);
        const V eta_above = tilted(q_above, load(*ends.over_square_above, i));
        const V eta_below = tilted(q_below, load(*ends.over_square_below, i));
        const V of_s = simd::norm(load(fields.s.a, i)), of_p = simd::norm(load(fields.p.a, i));
        // One division for the four denominators, which all are of a moderate size.
        const V above = q_above.re * eta_above, waves = of_s * of_p;
        const V over_all = 1.0 / (above * waves);
        const V over_s = over_all * above * of_p, over_p = over_all * above * of_s;
        const V t_s = over_s * load(fields.passed_s, i);
        const V t_p = over_p * load(fields.passed_p, i);
        store(s.R, i, over_s * simd::norm(load(fields.s.b, i)));
        store(p.R, i, over_p * simd::norm(load(fields.p.b, i)));
        store(s.T, i, over_all * waves * eta_above * q_below.re * t_s);
        store(p.T, i, over_all * waves * q_above.re * eta_below * t_p);
        const V least_s = load(fields.least_s, i), least_p = load(fields.least_p, i);
        // Few layers: no field was looked at on the way, none is larger than 1.
        const auto seen = (least_s < kLarge<double>) | (least_p < kLarge<double>);
        if (((seen[0] | seen[1]) | (seen[2] | seen[3])) == 0) continue;
        const V field_s = t_s / (least_s + kNotZero), field_p = t_p / (least_p + kNotZero);
        const V field = field_s > field_p ? field_s : field_p;
        store(doubt, i, load(doubt, i) * (field > 1.0 ? field : V{} + 1.0));
    }
}

NACRE_VECTOR_CLONES void find_mean_scales(MeanScales& out, const LaneEnds& ends)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C q_above = load(*ends.q_above, i), q_below = load(*ends.q_below, i);
        const V eta_above = tilted(q_above, load(*ends.over_square_above, i));
        const V eta_below = tilted(q_below, load(*ends.over_square_below, i));
        store(out.s, i, 0.5 * q_below.re / q_above.re);
        store(out.p, i, 0.5 * eta_below / eta_above);
    }
}

NACRE_VECTOR_CLONES void finish_mean(SingleLanes& R, SingleLanes& T, const FieldsOf<float>& fields,
                                     const SingleLanes& scale_s, const SingleLanes& scale_p)
{
    for (std::size_t i = 0; i < kLanes; i += simd::kWidthOf<float>) {
        const auto of_s = simd::norm(load(fields.s.a, i)), of_p = simd::norm(load(fields.p.a, i));
        const auto over_both = 1.0F / (of_s * of_p);
        const auto over_s = over_both * of_p, over_p = over_both * of_s;
        store(R, i,
              0.5F * (over_s * simd::norm(load(fields.s.b, i)) +
                      over_p * simd::norm(load(fields.p.b, i))));
        store(T, i,
              over_s * load(scale_s, i) * load(fields.passed_s, i) +
                  over_p * load(scale_p, i) * load(fields.passed_p, i));
    }
}

NACRE_VECTOR_CLONES void gather_phase(ComplexLanes& out, const std::vector<Crossing>& crossings,
                                      const std::vector<const ComplexLanes*>& half_trips)
{
    constexpr double kNotZero = 1e-300;
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        C product{V{} + 1.0, V{}};
        for (std::size_t j = crossings.size(); j-- > 0;) {
            product = product * load(*crossings[j].q_1, i);
            if (half_trips[j] != nullptr) product = product * load(*half_trips[j], i);
            if (j % kNormaliseEvery<double> != 0) continue;
            const V size = simd::absolute(product.re) + simd::absolute(product.im);
            product = (1.0 / (size + kNotZero)) * product;
        }
        store(out, i, (1.0 / (simd::square_root(simd::norm(product)) + kNotZero)) * product);
    }
}

NACRE_VECTOR_CLONES void finish_amplitudes(LaneAmplitudes& s, LaneAmplitudes& p,
                                           const LaneFields& fields, const ComplexLanes& phase,
                                           const LaneEnds& ends)
{
    for (std::size_t i = 0; i < kLanes; i += kWidth) {
        const C over_s = simd::reciprocal(load(fields.s.a, i));
        const C over_p = simd::reciprocal(load(fields.p.a, i));
        const C passed = load(phase, i);
        store(s.r, i, over_s * load(fields.s.b, i));
        store(p.r, i, over_p * load(fields.p.b, i));
        store(s.t, i, over_s * (simd::square_root(load(fields.passed_s, i)) * passed));
        // H was carried for p; E = H/n.
        const C to_field = load(*ends.n_above, i) * simd::reciprocal(load(*ends.n_below, i));
        store(p.t, i, to_field * (over_p * (simd::square_root(load(fields.passed_p, i)) * passed)));
    }
}

}  // namespace nacre::optics::detail
