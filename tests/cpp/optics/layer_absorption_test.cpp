// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "nacre/optics/multilayer.h"
#include "optics/light.h"

// What each layer takes.

namespace nacre::optics {
namespace {

double sum(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(LayerAbsorption, CoherentLayersAddUpToTheWhole)
{
    const FilmStack stack{
        1.0,
        {{1.4, 120.0}, {{0.47, 2.41}, 15.0}, {{1.8, 0.05}, 200.0}, {{0.05, 3.3}, 30.0}},
        {1.5, 0.02}};
    for (const double cosine : {1.0, 0.5, 0.05})
        for (const Polarisation polarisation : kBoth) {
            const std::vector<double> A = layer_absorption(stack, cosine, kNm, polarisation);
            const PowerRatios power = stack_power(stack, cosine, kNm, polarisation);
            EXPECT_NEAR(sum(A), power.A, 1e-14);
            EXPECT_NEAR(A[0], 0.0, 1e-16);
            for (std::size_t j = 1; j < A.size(); ++j) EXPECT_GT(A[j], 0.0);
        }
}

// Parts of one layer take together what the layer takes, and the upper one takes more.
TEST(LayerAbsorption, PartsOfALayer)
{
    const Complex n{1.6, 0.1};
    const FilmStack whole{1.0, {{2.0, 50.0}, {n, 400.0}}, 1.5};
    const FilmStack parts{1.0, {{2.0, 50.0}, {n, 150.0}, {n, 250.0}}, 1.5};
    for (const Polarisation polarisation : kBoth) {
        const auto A = layer_absorption(whole, 0.6, kNm, polarisation);
        const auto B = layer_absorption(parts, 0.6, kNm, polarisation);
        EXPECT_NEAR(A[1], B[1] + B[2], 1e-15);
        EXPECT_GT(B[1] / 150.0, B[2] / 250.0);
    }
}

// Nothing arrives behind an opaque layer, whose own share stays finite.
TEST(LayerAbsorption, OpaqueLayer)
{
    const FilmStack stack{1.0, {{{0.47, 2.41}, 50e3}, {{1.5, 0.1}, 100.0}}, 1.5};
    const auto A = layer_absorption(stack, 0.7, kNm, Polarisation::p);
    const PowerRatios power = stack_power(stack, 0.7, kNm, Polarisation::p);
    EXPECT_NEAR(A[0], 1.0 - power.R, 1e-15);
    EXPECT_EQ(A[1], 0.0);
}

// The weakly tinted pane of closed form, in a Beer–Lambert sum over its passages.
TEST(LayerAbsorption, IncoherentPane)
{
    const Complex n{1.52, 1e-6};
    const double d = 4e7, P = std::exp(-4.0 * std::numbers::pi * n.imag() * d / kNm);
    const FilmStack pane{1.0, {{n, d, false}}, 1.0};
    const auto A = layer_absorption(pane, 1.0, kNm, Polarisation::s);
    const double R = stack_power({1.0, {}, 1.52}, 1.0, kNm, Polarisation::s).R;
    EXPECT_NEAR(A[0], (1.0 - R) * (1.0 - P) / (1.0 - R * P), 1e-11);
    EXPECT_NEAR(A[0], stack_power(pane, 1.0, kNm, Polarisation::s).A, 1e-11);
}

TEST(LayerAbsorption, CoatedPaneAddsUp)
{
    const Complex silver{0.05, 3.3};
    const FilmStack pane{
        1.0, {{1.9, 60.0}, {silver, 12.0}, {1.52, 4e6, false}, {{2.2, 0.1}, 90.0}}, 1.0};
    for (const double cosine : {1.0, 0.3})
        for (const Polarisation polarisation : kBoth) {
            const auto A = layer_absorption(pane, cosine, kNm, polarisation);
            EXPECT_NEAR(sum(A), stack_power(pane, cosine, kNm, polarisation).A, 1e-14);
            EXPECT_NEAR(A[0], 0.0, 1e-16);
            EXPECT_NEAR(A[2], 0.0, 1e-16);
            EXPECT_GT(A[1], 0.0);
            EXPECT_GT(A[3], 0.0);
        }
}

}  // namespace
}  // namespace nacre::optics
