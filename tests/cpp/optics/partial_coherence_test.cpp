// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/optics/multilayer.h"
#include "optics/light.h"

// Layers whose phase is spread: mean of R and T over normally distributed phases.

namespace nacre::optics {
namespace {

using std::numbers::pi;

/// Clear layers only: their spread of phase is one of thickness.
PowerRatios mean_over_thickness(const FilmStack& stack, double cosine, Polarisation polarisation,
                                double step_nm, std::size_t layer = 0)
{
    while (layer < stack.layers.size() && stack.layers[layer].spread_nm == 0.0) ++layer;
    if (layer == stack.layers.size()) return stack_power(stack, cosine, kNm, polarisation);
    // The trapezoidal rule converges faster than any power of the step for a smooth function that
    // has died away at both ends.
    constexpr double kReach = 8.5;
    const double spread = stack.layers[layer].spread_nm, centre = stack.layers[layer].thickness_nm;
    const int steps = std::max(40, static_cast<int>(kReach * spread / step_nm));
    PowerRatios sum{};
    for (int i = -steps; i <= steps; ++i) {
        const double x = kReach * i / steps;
        const double weight = std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi) * kReach / steps;
        FilmStack one = stack;
        one.layers[layer] = {stack.layers[layer].n, centre + x * spread};
        const PowerRatios power =
            mean_over_thickness(one, cosine, polarisation, step_nm, layer + 1);
        sum.R += weight * power.R;
        sum.T += weight * power.T;
    }
    return sum;
}

void expect_mean(const FilmStack& stack, double tolerance, double step_nm = 3.0)
{
    for (const double cosine : {1.0, 0.5})
        for (const Polarisation polarisation : kBoth) {
            const PowerRatios expected = mean_over_thickness(stack, cosine, polarisation, step_nm);
            const PowerRatios got = stack_power(stack, cosine, kNm, polarisation);
            EXPECT_NEAR(got.R, expected.R, tolerance);
            EXPECT_NEAR(got.T, expected.T, tolerance);
        }
}

Layer spread(Complex n, double d_nm, double spread_nm)
{
    return {.n = n, .thickness_nm = d_nm, .spread_nm = spread_nm};
}

TEST(PartialCoherence, OneLayerIsTheMeanOverItsThickness)
{
    const Complex gold{0.47, 2.41};
    for (const double spread_nm : {0.5, 10.0, 60.0, 200.0}) {
        expect_mean({1.0, {spread(1.33, 2500.0, spread_nm)}, 1.0}, 1e-13);
        expect_mean({1.0, {spread(2.4, 2500.0, spread_nm)}, gold}, 1e-13, 1.5);
        expect_mean({1.2, {{gold, 20.0}, spread(1.5, 2500.0, spread_nm), {2.1, 80.0}}, gold},
                    1e-12);
    }
}

TEST(PartialCoherence, SeveralLayersAreTheMeanOverAllThicknesses)
{
    const Complex gold{0.47, 2.41};
    expect_mean({1.0, {spread(1.6, 1000.0, 30.0), spread(2.1, 900.0, 70.0)}, gold}, 1e-12, 6.0);
    expect_mean({1.0,
                 {{2.0, 70.0}, spread(1.5, 1500.0, 15.0), {gold, 10.0}, spread(2.4, 2000.0, 100.0)},
                 1.7},
                1e-12, 6.0);
}

TEST(PartialCoherence, ThreeLayers)
{
    const FilmStack stack{
        1.0, {spread(1.33, 800.0, 40.0), spread(1.7, 800.0, 40.0), spread(1.5, 800.0, 40.0)}, 2.0};
    const PowerRatios got = stack_power(stack, 1.0, kNm, Polarisation::s);
    // One layer at a time by quadrature, the other two by moments.
    PowerRatios expected{};
    for (int i = -60; i <= 60; ++i) {
        const double x = 0.15 * i, weight = 0.15 * std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi);
        FilmStack one = stack;
        one.layers[1] = {1.7, 800.0 + 40.0 * x};
        const PowerRatios power = stack_power(one, 1.0, kNm, Polarisation::s);
        expected.R += weight * power.R;
        expected.T += weight * power.T;
    }
    EXPECT_NEAR(got.R, expected.R, 1e-12);
    EXPECT_NEAR(got.T, expected.T, 1e-12);
}

// Nothing is lost on average that no single thickness loses.
TEST(PartialCoherence, ClearStacksKeepTheirPower)
{
    const FilmStack stack{1.0,
                          {spread(1.4, 300.0, 20.0),
                           spread(2.2, 150.0, 35.0),
                           {1.6, 90.0},
                           spread(1.8, 5000.0, 400.0)},
                          1.5};
    for (const double cosine : {1.0, 0.4, 0.05})
        for (const Polarisation polarisation : kBoth)
            EXPECT_NEAR(stack_power(stack, cosine, kNm, polarisation).A, 0.0, 1e-12);
}

// A phase that is spread over many turns leaves sums of intensities.
TEST(PartialCoherence, GreatSpreadIsIncoherent)
{
    const Complex gold{0.47, 2.41}, tinted{1.52, 1e-4};
    const std::vector<FilmStack> stacks{
        {1.0, {{tinted, 20e3, false}}, 1.0},
        {1.0, {{2.0, 80.0}, {tinted, 20e3, false}, {1.4, 60.0}}, gold},
    };
    for (FilmStack stack : stacks) {
        const PowerRatios expected = stack_power(stack, 0.6, kNm, Polarisation::p);
        for (Layer& layer : stack.layers)
            if (!layer.coherent) layer = spread(layer.n, layer.thickness_nm, 2000.0);
        const PowerRatios got = stack_power(stack, 0.6, kNm, Polarisation::p);
        // The interface carries powers that do not quite add in an absorbing medium: k/n of them.
        EXPECT_NEAR(got.R, expected.R, 1e-4);
        EXPECT_NEAR(got.T, expected.T, 1e-4);
    }
}

TEST(PartialCoherence, ClearPaneOfGreatSpreadIsExactlyIncoherent)
{
    const PowerRatios incoherent =
        stack_power({1.0, {{1.52, 20e3, false}}, 1.0}, 0.6, kNm, Polarisation::p);
    const PowerRatios spread_out =
        stack_power({1.0, {spread(1.52, 20e3, 2000.0)}, 1.0}, 0.6, kNm, Polarisation::p);
    EXPECT_NEAR(spread_out.R, incoherent.R, 1e-15);
    EXPECT_NEAR(spread_out.T, incoherent.T, 1e-15);
}

TEST(PartialCoherence, NoSpreadIsCoherent)
{
    const FilmStack plain{1.0, {{1.4, 300.0}, {{2.0, 0.5}, 40.0}, {1.6, 700.0}}, 1.5};
    FilmStack stack = plain;
    stack.layers[0].spread_nm = stack.layers[2].spread_nm = 1e-9;
    for (const Polarisation polarisation : kBoth) {
        const PowerRatios expected = stack_power(plain, 0.7, kNm, polarisation);
        const PowerRatios got = stack_power(stack, 0.7, kNm, polarisation);
        EXPECT_NEAR(got.R, expected.R, 1e-13);
        EXPECT_NEAR(got.T, expected.T, 1e-13);
    }
}

// Two strong mirrors: a series of thousands of terms, cut off by the spread or by itself.
TEST(PartialCoherence, SharpResonance)
{
    FilmStack etalon{1.0, {}, 1.0};
    const auto mirror = [&etalon](bool reversed) {
        for (int j = 0; j < 15; ++j)
            etalon.layers.push_back((j % 2 == 0) != reversed ? Layer{2.4, kNm / 9.6}
                                                             : Layer{1.4, kNm / 5.6});
    };
    mirror(false);
    etalon.layers.push_back(spread(1.0, 10.0 * kNm, 0.05));
    mirror(false);
    expect_mean(etalon, 1e-12, 0.001);
}

TEST(PartialCoherence, SpreadInsideAnIncoherentStack)
{
    const FilmStack stack{1.0, {spread(1.4, 900.0, 50.0), {1.52, 1e6, false}}, 1.0};
    expect_mean(stack, 2e-3);
    // Powers of the coated face, put into the series by hand.
    for (const Polarisation polarisation : kBoth) {
        const PowerRatios front =
            stack_power({1.0, {spread(1.4, 900.0, 50.0)}, 1.52}, 1.0, kNm, polarisation);
        const double R_rear = stack_power({1.52, {}, 1.0}, 1.0, kNm, polarisation).R;
        const double expected = front.R + front.T * front.T * R_rear / (1.0 - front.R * R_rear);
        EXPECT_NEAR(stack_power(stack, 1.0, kNm, polarisation).R, expected, 1e-14);
    }
}

// A band of wavelengths and a spread of thickness are one and the same to a single layer.
TEST(PartialCoherence, BandOfWavelengths)
{
    const FilmStack film{1.0, {{1.33, 20e3}}, 1.0};
    const double sigma = 2.0 / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    const PowerRatios got = stack_power(seen_in_band(film, 2.0, kNm), 1.0, kNm, Polarisation::s);
    double expected = 0.0;
    for (int i = -2000; i <= 2000; ++i) {
        const double x = 0.004 * i, weight = 0.004 * std::exp(-0.5 * x * x) / std::sqrt(2.0 * pi);
        // The band is narrow and Gaussian in wavenumber.
        const double nm = 1.0 / (1.0 / kNm + x * sigma / (kNm * kNm));
        expected += weight * stack_power(film, 1.0, nm, Polarisation::s).R;
    }
    EXPECT_NEAR(got.R, expected, 1e-12);
    EXPECT_GT(std::abs(got.R - stack_power(film, 1.0, kNm, Polarisation::s).R), 1e-3);
}

TEST(PartialCoherence, ValidateNamesTheSpread)
{
    FilmStack stack{1.0, {{1.4, 100.0}}, 1.5};
    for (const double bad : {-1.0, std::numeric_limits<double>::infinity()}) {
        stack.layers[0].spread_nm = bad;
        ASSERT_TRUE(validate(stack));
        EXPECT_STREQ(validate(stack)->field, "spread_nm");
    }
    stack.layers[0] = {1.4, 100.0, false, 5.0};
    ASSERT_TRUE(validate(stack));
    EXPECT_STREQ(validate(stack)->message, "must be 0 in a layer that is incoherent");
}

}  // namespace
}  // namespace nacre::optics
