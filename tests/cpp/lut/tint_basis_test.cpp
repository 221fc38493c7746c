// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/tint_basis.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/library/lights.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/wavelength_sampling.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

WavelengthCells white_cells()
{
    const spectral::ColourWeights weights = spectral::reflectance_weights(
        spectral::named_illuminant("D65"), spectral::ObserverId::cie1931,
        spectral::colour_space("lin_rec709_scene"));
    const spectral::WavelengthSampling sampling = spectral::sample_wavelengths(weights, 64);
    WavelengthCells cells{.nm = {}, .weight = sampling.weight, .reflectance = {}};
    for (std::size_t i = 0; i < sampling.weight.size(); ++i) {
        cells.nm.push_back(0.5 * (sampling.edges_nm[i] + sampling.edges_nm[i + 1]));
        cells.reflectance.push_back(1.0);
    }
    return cells;
}

/// Dark in the blue and bright in the red, as copper is.
WavelengthCells copper_cells()
{
    WavelengthCells cells = white_cells();
    for (std::size_t i = 0; i < cells.nm.size(); ++i)
        cells.reflectance[i] = 0.45 + 0.5 / (1.0 + std::exp((575.0 - cells.nm[i]) / 12.0));
    return cells;
}

double scalar(const Vec3& tint, const Vec3& basis)
{
    return tint[0] * basis[0] + tint[1] * basis[1] + tint[2] * basis[2];
}

Vec3 mean_colour(const WavelengthCells& cells, const std::vector<Vec3>& basis, const Vec3& tint)
{
    Vec3 sum{};
    for (std::size_t i = 0; i < basis.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] +=
                cells.weight[i][k] * scalar(tint, basis[i]) / static_cast<double>(basis.size());
    return sum;
}

void expect_mean_is_the_tint(const WavelengthCells& cells)
{
    const std::vector<Vec3> basis = tint_basis(cells);
    ASSERT_EQ(basis.size(), cells.nm.size());
    for (const Vec3 tint : {Vec3{1, 1, 1}, Vec3{1, 0.5, 0.25}, Vec3{0, 0, 1}, Vec3{0, 1, 0},
                            Vec3{1, 0, 0}, Vec3{0.9, 0.52, 0.41}}) {
        const Vec3 mean = mean_colour(cells, basis, tint);
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(mean[k], tint[k], 1e-5);
    }
}

TEST(TintBasis, MeanOverTheCellsIsTheTint)
{
    expect_mean_is_the_tint(white_cells());
    expect_mean_is_the_tint(copper_cells());
}

TEST(TintBasis, WhiteTakesNothingFromAnyWavelength)
{
    for (const Vec3& triple : tint_basis(white_cells()))
        EXPECT_NEAR(scalar({1, 1, 1}, triple), 1.0, 1e-6);
}

TEST(TintBasis, MetalOfItsOwnColourReflectsAsItDoes)
{
    const WavelengthCells cells = copper_cells();
    const std::vector<Vec3> basis = tint_basis(cells);
    Vec3 own{};
    for (std::size_t i = 0; i < basis.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            own[k] += cells.weight[i][k] * cells.reflectance[i] / static_cast<double>(basis.size());
    for (std::size_t i = 0; i < basis.size(); ++i)
        EXPECT_NEAR(scalar(own, basis[i]), cells.reflectance[i], 1e-6);
}

TEST(TintBasis, NoTintIsBelowZeroInAnyCell)
{
    for (const WavelengthCells& cells : {white_cells(), copper_cells()})
        for (const Vec3& triple : tint_basis(cells))
            for (const double value : triple) EXPECT_GE(value, 0.0);
}

TEST(TintBasis, LightOfOneLineAndBlackMetalGiveNumbers)
{
    WavelengthCells cells = white_cells();
    for (std::size_t i = 0; i < cells.nm.size(); ++i) {
        cells.weight[i] = cells.weight[40];
        cells.reflectance[i] = 0.0;
    }
    for (const Vec3& triple : tint_basis(cells))
        for (const double value : triple) EXPECT_TRUE(std::isfinite(value) && value >= 0.0);
}

}  // namespace
}  // namespace nacre::lut
