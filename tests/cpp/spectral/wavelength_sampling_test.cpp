// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/wavelength_sampling.h"
#include "nacre/library/lights.h"

#include <algorithm>
#include <cmath>

#include "support/expect.h"

namespace nacre::spectral {
namespace {

ColourWeights weights_for(const char* illuminant, const char* space)
{
    return reflectance_weights(named_illuminant(illuminant), ObserverId::cie1931,
                               colour_space(space));
}

TEST(WavelengthSampling, MeanOfAllWeightsIsWhite)
{
    for (const char* illuminant : {"D65", "A", "E"})
        for (const auto& name : colour_space_names())
            for (const int cells : {kFewestCells, 64, 256, 1000}) {
                const ColourWeights weights = weights_for(illuminant, name.c_str());
                Sampled one;
                one.fill(1.0);
                const Vec3 white = weights.apply(one);
                Vec3 mean{};
                const auto sampling = sample_wavelengths(weights, cells);
                ASSERT_EQ(sampling.weight.size(), static_cast<std::size_t>(cells));
                for (const Vec3& weight : sampling.weight)
                    for (std::size_t c = 0; c < 3; ++c) mean[c] += weight[c] / cells;
                for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], white[c], 1e-12) << cells;
            }
}

TEST(WavelengthSampling, CellsCoverTheGridAndNoneIsTooWide)
{
    for (const int cells : {kFewestCells, 13, 64, 256, 4096}) {
        const auto sampling = sample_wavelengths(weights_for("D65", "lin_rec709_scene"), cells);
        ASSERT_EQ(sampling.edges_nm.size(), static_cast<std::size_t>(cells) + 1);
        EXPECT_EQ(sampling.edges_nm.front(), 360.0);
        EXPECT_EQ(sampling.edges_nm.back(), 830.0);
        for (std::size_t i = 0; i + 1 < sampling.edges_nm.size(); ++i) {
            EXPECT_GT(sampling.edges_nm[i + 1], sampling.edges_nm[i]) << cells << ' ' << i;
            EXPECT_LE(sampling.edges_nm[i + 1] - sampling.edges_nm[i], 40.0 + 1e-9) << cells;
        }
    }
}

// Drawn with the cells, a smooth reflectance has the colour that the sum over the grid gives it.
TEST(WavelengthSampling, EstimatesTheColourOfASpectrum)
{
    const ColourWeights weights = weights_for("D65", "lin_rec709_scene");
    const auto reflectance = [](double nm) { return 0.5 + 0.4 * std::cos((nm - 400.0) / 60.0); };
    Sampled sampled;
    for (std::size_t i = 0; i < kWavelengths; ++i) sampled[i] = reflectance(wavelength_nm(i));
    const Vec3 exact = weights.apply(sampled);

    constexpr int kCells = 1024;
    const auto sampling = sample_wavelengths(weights, kCells);
    Vec3 estimate{};
    for (std::size_t i = 0; i < kCells; ++i) {
        const double centre = (sampling.edges_nm[i] + sampling.edges_nm[i + 1]) / 2.0;
        for (std::size_t c = 0; c < 3; ++c)
            estimate[c] += sampling.weight[i][c] * reflectance(centre) / kCells;
    }
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(estimate[c], exact[c], 2e-4) << c;
}

TEST(WavelengthSampling, DrawsWhereTheEyeSees)
{
    const auto sampling = sample_wavelengths(weights_for("D65", "lin_rec709_scene"), 256);
    const auto below = [&](double nm) {
        return std::ranges::count_if(sampling.edges_nm, [nm](double edge) { return edge < nm; });
    };
    EXPECT_LT(below(400.0), 20);
    EXPECT_GT(below(700.0), 230);
    // Single wavelengths lie outside the gamut: weights are signed.
    EXPECT_TRUE(std::ranges::any_of(sampling.weight, [](const Vec3& w) { return w[0] < -0.1; }));
}

}  // namespace
}  // namespace nacre::spectral
