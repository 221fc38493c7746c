// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/optics/multilayer.h"
#include "optics/light.h"

// Layers across which intensities are added.

namespace nacre::optics {
namespace {

using std::numbers::pi;

constexpr double kPane = 4e6;  // nm

double interface_reflectance(Complex n_i, Complex n_t, double cosine, Polarisation polarisation)
{
    return stack_power({n_i, {}, n_t}, cosine, kNm, polarisation).R;
}

// Both faces reflect R: R (1 + T²/(1 − R²)) = 2R/(1 + R).
TEST(IncoherentLayers, PaneHasClosedForm)
{
    const FilmStack pane{1.0, {{1.52, kPane, false}}, 1.0};
    for (const double cosine : {1.0, 0.6, 0.2, 0.001}) {
        for (const Polarisation polarisation : kBoth) {
            const double R = interface_reflectance(1.0, 1.52, cosine, polarisation);
            const PowerRatios power = stack_power(pane, cosine, kNm, polarisation);
            EXPECT_NEAR(power.R, R * (1.0 + (1.0 - R) * (1.0 - R) / (1.0 - R * R)), 1e-15);
            EXPECT_NEAR(power.T, (1.0 - R) / (1.0 + R), 1e-15);
            EXPECT_NEAR(power.A, 0.0, 1e-15);
        }
    }
}

// T = (1 − R)²P/(1 − R²P²) with P = exp(−4πkd/λ), at normal incidence; k² is too small to count
// in R.
TEST(IncoherentLayers, TintedPaneHasClosedForm)
{
    const Complex n{1.52, 1e-5};
    const FilmStack pane{1.0, {{n, kPane, false}}, 1.0};
    const double R = interface_reflectance(1.0, 1.52, 1.0, Polarisation::s);
    const double P = std::exp(-4.0 * pi * n.imag() * kPane / kNm);
    ASSERT_LT(P, 0.5);
    const PowerRatios power = stack_power(pane, 1.0, kNm, Polarisation::s);
    const double series = 1.0 - R * R * P * P;
    EXPECT_NEAR(power.T, (1.0 - R) * (1.0 - R) * P / series, 1e-10);
    EXPECT_NEAR(power.R, R + (1.0 - R) * (1.0 - R) * R * P * P / series, 1e-10);
}

// N plates with gaps: T = (1 − R)/(1 + (2N − 1) R) (Stokes' pile of plates).
TEST(IncoherentLayers, PileOfPlatesHasClosedForm)
{
    FilmStack pile{1.0, {{1.52, kPane, false}}, 1.0};
    for (int plates = 1; plates <= 20; ++plates) {
        for (const Polarisation polarisation : kBoth) {
            const double R = interface_reflectance(1.0, 1.52, 0.5, polarisation);
            EXPECT_NEAR(stack_power(pile, 0.5, kNm, polarisation).T,
                        (1.0 - R) / (1.0 + (2 * plates - 1) * R), 1e-14);
        }
        pile.layers.push_back({1.0, kPane, false});
        pile.layers.push_back({1.52, kPane, false});
    }
}

// Adding intensities is the mean over the phase of the layer: the trapezium rule over one period is
// exact to rounding for a series that falls like (r r')^m.
TEST(IncoherentLayers, IntensitiesAreTheMeanOverThePhase)
{
    constexpr int kSteps = 64;
    const Complex substrate{0.6, 3.1};
    const double cosine = 0.7, q = 2.0 * forward_cosine(1.0, 2.0, cosine).real();
    const Layer top{1.38, 95.0}, bottom{{1.7, 0.1}, 60.0};
    for (const Polarisation polarisation : kBoth) {
        double R = 0.0, T = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const FilmStack stack{
                1.0, {top, {2.0, kNm / (2.0 * q) * i / kSteps}, bottom}, substrate};
            const PowerRatios power = stack_power(stack, cosine, kNm, polarisation);
            R += power.R / kSteps;
            T += power.T / kSteps;
        }
        const FilmStack mean{1.0, {top, {2.0, kPane, false}, bottom}, substrate};
        const PowerRatios power = stack_power(mean, cosine, kNm, polarisation);
        EXPECT_NEAR(power.R, R, 1e-14);
        EXPECT_NEAR(power.T, T, 1e-14);
    }
}

TEST(IncoherentLayers, ThicknessOfAClearPaneDoesNotCount)
{
    const FilmStack thin{1.0, {{2.4, 60.0}, {1.52, 0.0, false}}, 1.33};
    const FilmStack thick{1.0, {{2.4, 60.0}, {1.52, 1e9, false}}, 1.33};
    for (const Polarisation polarisation : kBoth)
        EXPECT_EQ(stack_power(thin, 0.6, kNm, polarisation).R,
                  stack_power(thick, 0.6, kNm, polarisation).R);
}

TEST(IncoherentLayers, NothingReturnsThroughAnOpaqueOne)
{
    const FilmStack opaque{1.0, {{1.38, 90.0}, {{1.5, 0.5}, 1e6, false}}, {0.2, 4.0}};
    const FilmStack bulk{1.0, {{1.38, 90.0}}, {1.5, 0.5}};
    for (const Polarisation polarisation : kBoth) {
        const PowerRatios power = stack_power(opaque, 0.6, kNm, polarisation);
        EXPECT_NEAR(power.R, stack_power(bulk, 0.6, kNm, polarisation).R, 1e-15);
        EXPECT_EQ(power.T, 0.0);
    }
}

TEST(IncoherentLayers, TotalReflectionIsTotalInsideAndInFront)
{
    const FilmStack inside{1.5, {{1.6, kPane, false}}, 1.0};  // at the far face
    const FilmStack front{1.5, {{1.0, kPane, false}}, 1.5};   // at the near one
    const FilmStack film{1.5, {{1.38, 90.0}, {1.0, kPane, false}, {1.4, 20.0}}, 1.5};
    for (const FilmStack& stack : {inside, front, film}) {
        for (const Polarisation polarisation : kBoth) {
            const PowerRatios power = stack_power(stack, 0.5, kNm, polarisation);
            EXPECT_NEAR(power.R, 1.0, 1e-15);
            EXPECT_EQ(power.T, 0.0);
        }
    }
}

}  // namespace
}  // namespace nacre::optics
