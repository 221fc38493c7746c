// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "nacre/optics/multilayer.h"

namespace nacre::optics {
namespace {

struct Lane {
    FilmStack stack;
    double cosine, nm;
};

void set(ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

LaneStack pack(const std::vector<Lane>& lanes)
{
    LaneStack packed;
    packed.layers.resize(lanes.front().stack.layers.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
        const auto& [stack, cosine, nm] = lanes[i];
        packed.n_0[i] = stack.ambient.real();
        packed.cos_0[i] = cosine;
        set(packed.above, i, stack.ambient);
        set(packed.below, i, stack.substrate);
        for (std::size_t j = 0; j < packed.layers.size(); ++j) {
            set(packed.layers[j].n, i, stack.layers[j].n);
            packed.layers[j].waves[i] = stack.layers[j].thickness_nm / nm;
        }
    }
    return packed;
}

/// Unlike stacks of one depth: clear films, weak absorbers and metals side by side.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}

    double operator()(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }
    Complex index()
    {
        const double kind = (*this)(0.0, 1.0);
        if (kind < 0.5) return (*this)(1.2, 2.8);
        if (kind < 0.8) return {(*this)(1.2, 2.8), (*this)(0.0, 0.1)};
        return {(*this)(0.05, 4.0), (*this)(0.5, 7.0)};
    }
    std::vector<Lane> lanes(std::size_t layers, double thickest_nm)
    {
        std::vector<Lane> result;
        for (std::size_t i = 0; i < kLanes; ++i) {
            Lane lane{
                {(*this)(1.0, 1.6), {}, index()}, (*this)(0.0017, 1.0), (*this)(360.0, 830.0)};
            for (std::size_t j = 0; j < layers; ++j)
                lane.stack.layers.push_back({index(), (*this)(0.0, thickest_nm)});
            result.push_back(std::move(lane));
        }
        return result;
    }

private:
    std::mt19937 engine_;
};

struct Difference {
    double power = 0.0, amplitude = 0.0;
};

/// How far a lane is from the exact response, t relative to what it can at most be.
Difference difference(const Lane& lane, Polarisation polarisation, const LanePower& powers,
                      const LaneAmplitudes& amplitudes, std::size_t i)
{
    const auto [r, t] = stack_amplitudes(lane.stack, lane.cosine, lane.nm, polarisation);
    const PowerRatios power = stack_power(lane.stack, lane.cosine, lane.nm, polarisation);
    const Complex ours_r(amplitudes.r.re[i], amplitudes.r.im[i]),
        ours_t(amplitudes.t.re[i], amplitudes.t.im[i]);
    return {std::max(std::abs(powers.R[i] - power.R), std::abs(powers.T[i] - power.T)),
            std::max(std::abs(ours_r - r), std::abs(ours_t - t) / std::max(1.0, std::abs(t)))};
}

void expect_promised_accuracy(const std::vector<Lane>& lanes)
{
    BatchPower power;
    BatchAmplitudes amplitudes;
    stack_batch(pack(lanes), power, amplitudes);
    const double layers = static_cast<double>(lanes.front().stack.layers.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double allowed = 1e-13 * std::max(1.0, layers) + power.doubt[i];
        for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
            const bool s = polarisation == Polarisation::s;
            const Difference off = difference(lanes[i], polarisation, s ? power.s : power.p,
                                              s ? amplitudes.s : amplitudes.p, i);
            EXPECT_LE(off.power, allowed) << "lane " << i << ", " << layers << " layers";
            EXPECT_LE(off.amplitude, allowed) << "lane " << i << ", " << layers << " layers";
        }
    }
}

TEST(StackBatch, AgreesWithOneByOne)
{
    Random random(1);
    for (const std::size_t layers : {0, 1, 2, 3, 7, 16, 40, 64})
        for (int batch = 0; batch < 12; ++batch)
            expect_promised_accuracy(random.lanes(layers, 400.0));
}

TEST(StackBatch, ThickAbsorbersUnderflowQuietly)
{
    Random random(2);
    for (int batch = 0; batch < 12; ++batch) expect_promised_accuracy(random.lanes(3, 5e4));
    std::vector<Lane> opaque = random.lanes(2, 100.0);
    for (Lane& lane : opaque) lane.stack.layers[1] = {{0.2, 3.4}, 5e4};
    BatchPower response;
    stack_batch(pack(opaque), response);
    for (std::size_t i = 0; i < kLanes; ++i) {
        EXPECT_EQ(response.s.T[i], 0.0);
        EXPECT_EQ(response.p.T[i], 0.0);
        EXPECT_TRUE(std::isfinite(response.s.R[i]) && std::isfinite(response.p.R[i]));
    }
}

TEST(StackBatch, GapsAndTotalReflectionAgree)
{
    std::vector<Lane> lanes;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double cosine = 0.02 + 0.02 * static_cast<double>(i);  // all beyond 1/1.5
        lanes.push_back(
            {{1.5, {{1.0, 20.0 * static_cast<double>(i)}, {1.2, 90.0}}, 1.0}, cosine, 550.0});
    }
    expect_promised_accuracy(lanes);
    for (Lane& lane : lanes) lane.stack.substrate = 1.5;
    expect_promised_accuracy(lanes);
}

// Near a film's critical angle double precision loses digits; `doubt` says so and is no idle
// threat.
TEST(StackBatch, DoubtMarksCriticalAngles)
{
    std::vector<Lane> lanes;
    for (std::size_t i = 0; i < kLanes; ++i)
        lanes.push_back({{1.25, {{0.75, 2000.0}, {1.4, 80.0}}, 1.6},
                         0.8 + std::ldexp(1.0, -4 - static_cast<int>(i)),
                         550.0});
    expect_promised_accuracy(lanes);
    BatchPower response;
    stack_batch(pack(lanes), response);
    for (std::size_t i = 1; i < kLanes; ++i) EXPECT_GT(response.doubt[i], response.doubt[i - 1]);
    EXPECT_LT(response.doubt[0], 1e-13);
    EXPECT_GT(response.doubt[kLanes - 1], 1e-11);
}

TEST(StackBatch, LanesDoNotSeeEachOther)
{
    Random random(3);
    std::vector<Lane> lanes = random.lanes(5, 300.0);
    BatchPower before, after;
    BatchAmplitudes before_t, after_t;
    stack_batch(pack(lanes), before, before_t);
    std::rotate(lanes.begin(), lanes.begin() + 5, lanes.end());
    stack_batch(pack(lanes), after, after_t);
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t was = (i + 5) % kLanes;
        EXPECT_EQ(bits(after.s.R[i]), bits(before.s.R[was]));
        EXPECT_EQ(bits(after.p.T[i]), bits(before.p.T[was]));
        EXPECT_EQ(bits(after_t.p.t.im[i]), bits(before_t.p.t.im[was]));
        EXPECT_EQ(bits(after.doubt[i]), bits(before.doubt[was]));
    }
}

TEST(MixedStack, AnyCoherenceAgrees)
{
    Random random(4);
    for (std::size_t layers = 1; layers <= 6; ++layers) {
        for (unsigned pattern = 0; pattern < 1U << layers; ++pattern) {
            std::vector<Lane> lanes = random.lanes(layers, 300.0);
            std::vector<bool> coherent(layers);
            for (std::size_t j = 0; j < layers; ++j) coherent[j] = (pattern >> j & 1U) != 0;
            for (Lane& lane : lanes) {
                for (std::size_t j = 0; j < layers; ++j) {
                    Layer& layer = lane.stack.layers[j];
                    layer.coherent = coherent[j];
                    // A pane: clear and thick, or else intensities do not add up.
                    if (!coherent[j]) layer = {{random(1.2, 2.8), random(0.0, 1e-6)}, 1e6, false};
                }
            }
            Lanes R, T;
            MixedStack(pack(lanes), coherent, std::nullopt).march(1.0, 0.0, {&R, 1}, {&T, 1});
            for (std::size_t i = 0; i < kLanes; ++i) {
                const auto power =
                    stack_power_unpolarised(lanes[i].stack, lanes[i].cosine, lanes[i].nm);
                EXPECT_NEAR(R[i], power.R, 1e-12);
                EXPECT_NEAR(T[i], power.T, 1e-12);
            }
        }
    }
}

/// Rows of a march against the exact response, for any way to change a lane by row.
template <class Change>
void expect_rows(const std::vector<Lane>& lanes, const std::vector<Lanes>& R,
                 const std::vector<Lanes>& T, double tolerance, Change&& change)
{
    for (std::size_t row = 0; row < R.size(); ++row) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            FilmStack stack = lanes[i].stack;
            change(stack, i, row);
            const auto power = stack_power_unpolarised(stack, lanes[i].cosine, lanes[i].nm);
            ASSERT_NEAR(R[row][i], power.R, tolerance) << "row " << row << ", lane " << i;
            ASSERT_NEAR(T[row][i], power.T, tolerance) << "row " << row << ", lane " << i;
        }
    }
}

TEST(PhaseMap, MarchesOverTheThicknessOfOneLayer)
{
    Random random(5);
    constexpr double kFirst = 3.0, kStep = 7.5;  // nm
    for (const std::size_t layers : {1, 2, 9}) {
        for (std::size_t varying = 0; varying < layers; ++varying) {
            const std::vector<Lane> lanes = random.lanes(layers, 300.0);
            Lanes first, step;
            for (std::size_t i = 0; i < kLanes; ++i) {
                first[i] = kFirst / lanes[i].nm;
                step[i] = kStep / lanes[i].nm;
            }
            std::vector<Lanes> R(40), T(40);
            PhaseMap(pack(lanes), varying).march(first, step, R, T);
            expect_rows(lanes, R, T, 1e-12, [&](FilmStack& stack, std::size_t, std::size_t row) {
                stack.layers[varying].thickness_nm = kFirst + kStep * static_cast<double>(row);
            });
        }
    }
}

/// Largest difference of two marches.
double off(const std::vector<Lanes>& exact, const std::vector<SingleLanes>& single)
{
    double worst = 0.0;
    for (std::size_t row = 0; row < exact.size(); ++row)
        for (std::size_t i = 0; i < kLanes; ++i)
            worst = std::max(worst, std::abs(exact[row][i] - static_cast<double>(single[row][i])));
    return worst;
}

TEST(PhaseMap, SinglePrecisionIsNear)
{
    Random random(11);
    Lanes first, step;
    for (std::size_t i = 0; i < kLanes; ++i) {
        first[i] = random(0.0, 20.0);
        step[i] = random(0.0, 0.1);
    }
    std::vector<Lanes> R(32), T(32);
    std::vector<SingleLanes> single_R(32), single_T(32);
    for (const std::size_t layers : {1, 3, 12})
        for (std::size_t varying = 0; varying < layers; ++varying) {
            const PhaseMap map(pack(random.lanes(layers, 200.0)), varying);
            map.march(first, step, R, T);
            map.march(first, step, single_R, single_T);
            EXPECT_LE(off(R, single_R), 2e-5) << layers;
            EXPECT_LE(off(T, single_T), 2e-5) << layers;
        }
}

TEST(ScaledStack, SinglePrecisionIsNear)
{
    Random random(12);
    std::vector<Lanes> R(32), T(32);
    std::vector<SingleLanes> single_R(32), single_T(32);
    for (const std::size_t layers : {0, 1, 5, 20, 64}) {
        const ScaledStack scaled(pack(random.lanes(layers, 150.0)));
        scaled.march(0.25, 0.05, R, T);
        scaled.march(0.25, 0.05, single_R, single_T);
        EXPECT_LE(off(R, single_R), 2e-5) << layers;
        EXPECT_LE(off(T, single_T), 2e-5) << layers;
    }
}

// The thickness that the stack came with is not read.
TEST(PhaseMap, ForgetsTheThicknessOfItsLayer)
{
    Random random(6);
    std::vector<Lane> lanes = random.lanes(3, 300.0);
    Lanes first, step;
    first.fill(0.1);
    step.fill(0.02);
    std::vector<Lanes> R(4), T(4), other_R(4), other_T(4);
    PhaseMap(pack(lanes), 1).march(first, step, R, T);
    for (Lane& lane : lanes) lane.stack.layers[1].thickness_nm = 1e6;
    PhaseMap(pack(lanes), 1).march(first, step, other_R, other_T);
    EXPECT_EQ(R, other_R);
    EXPECT_EQ(T, other_T);
}

TEST(ScaledStack, MarchesOverAFactorOnAllThicknesses)
{
    Random random(7);
    constexpr double kFirst = 0.25, kStep = 0.05;
    for (const std::size_t layers : {0, 1, 5, 20}) {
        const std::vector<Lane> lanes = random.lanes(layers, 150.0);
        std::vector<Lanes> R(40), T(40);
        ScaledStack(pack(lanes)).march(kFirst, kStep, R, T);
        expect_rows(lanes, R, T, 1e-12, [&](FilmStack& stack, std::size_t, std::size_t row) {
            for (Layer& layer : stack.layers)
                layer.thickness_nm *= kFirst + kStep * static_cast<double>(row);
        });
    }
}

TEST(ScaledStack, StartsAtTheBareSubstrate)
{
    Random random(8);
    const std::vector<Lane> lanes = random.lanes(4, 150.0);
    std::vector<Lanes> R(1), T(1);
    ScaledStack(pack(lanes)).march(0.0, 1.0, R, T);
    expect_rows(lanes, R, T, 1e-14,
                [](FilmStack& stack, std::size_t, std::size_t) { stack.layers.clear(); });
}

/// Coating, pane, coating of two layers, pane, coating; panes are clear and thick.
std::vector<Lane> coated_panes(Random& random, std::vector<bool>& coherent)
{
    coherent = {true, false, true, true, false, true};
    std::vector<Lane> lanes = random.lanes(coherent.size(), 200.0);
    for (Lane& lane : lanes)
        for (std::size_t j = 0; j < coherent.size(); ++j)
            if (!coherent[j])
                lane.stack.layers[j] = {{random(1.2, 2.8), random(0.0, 1e-6)}, 1e6, false};
    return lanes;
}

TEST(MixedStack, MarchesOverAFactorOnCoherentThicknesses)
{
    Random random(9);
    constexpr double kFirst = 0.5, kStep = 0.1;
    std::vector<bool> coherent;
    const std::vector<Lane> lanes = coated_panes(random, coherent);
    std::vector<Lanes> R(12), T(12);
    MixedStack(pack(lanes), coherent, std::nullopt).march(kFirst, kStep, R, T);
    expect_rows(lanes, R, T, 1e-12, [](FilmStack& stack, std::size_t, std::size_t row) {
        for (Layer& layer : stack.layers)
            if (layer.coherent) layer.thickness_nm *= kFirst + kStep * static_cast<double>(row);
    });
}

// Also where another layer has the same medium and the thickness that the varying one came with.
TEST(MixedStack, MarchesOverTheThicknessOfOneLayer)
{
    Random random(10);
    constexpr double kFirst = 10.0, kStep = 12.5;  // nm
    std::vector<bool> coherent;
    std::vector<Lane> lanes = coated_panes(random, coherent);
    for (Lane& lane : lanes) lane.stack.layers[3] = lane.stack.layers[2];
    for (const std::size_t varying : {0, 2, 3, 5}) {
        Lanes first, step;
        for (std::size_t i = 0; i < kLanes; ++i) {
            first[i] = kFirst / lanes[i].nm;
            step[i] = kStep / lanes[i].nm;
        }
        std::vector<Lanes> R(12), T(12);
        MixedStack(pack(lanes), coherent, varying).march(first, step, R, T);
        expect_rows(lanes, R, T, 1e-12, [&](FilmStack& stack, std::size_t, std::size_t row) {
            stack.layers[varying].thickness_nm = kFirst + kStep * static_cast<double>(row);
        });
    }
}

TEST(MixedStack, TurnsLikeANewOne)
{
    Random random(11);
    std::vector<bool> coherent;
    const std::vector<Lane> lanes = coated_panes(random, coherent);
    const LaneStack stack = pack(lanes);
    LaneStack head_on = stack;
    head_on.cos_0.fill(1.0);
    MixedStack turned(head_on, coherent, std::nullopt);
    turned.turn_to(stack.cos_0);
    std::vector<Lanes> R(3), T(3), other_R(3), other_T(3);
    turned.march(0.7, 0.3, R, T);
    MixedStack(stack, coherent, std::nullopt).march(0.7, 0.3, other_R, other_T);
    EXPECT_EQ(R, other_R);
    EXPECT_EQ(T, other_T);
}

}  // namespace
}  // namespace nacre::optics
