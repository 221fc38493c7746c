// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/inner_tables.h"

#include <gtest/gtest.h>

#include "films.h"
#include "nacre/core/diagnostics.h"

namespace nacre::lut {
namespace {

using test::constant;

/// What a hemisphere of light in the glass sends out, from the other side: T is the same both ways
/// along a ray, and a solid angle outside is n² times the one inside.
double transmitted_from_above(const FilmTableRequest& request, double value, std::size_t channel)
{
    constexpr int kSteps = 4000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double c = (i + 0.5) / kSteps;
        sum += exact_film_colour(request, c, value).transmittance[channel] * 2.0 * c;
    }
    return sum / kSteps / (1.5 * 1.5);
}

TEST(InnerTables, BareGlassReturnsWhatTheTextbooksSay)
{
    const auto bare = test::request(constant(1.0), {}, constant(1.5), std::nullopt);
    const InnerTables tables = bake_inner_tables(bare, 7);

    EXPECT_EQ(tables.reflectance.name(), "R_inner");
    EXPECT_EQ(tables.transmittance.name(), "T_inner");
    EXPECT_EQ(tables.reflectance.x.texels, 1);
    EXPECT_EQ(tables.reflectance.y.texels, 1) << "nothing varies";
    ASSERT_EQ(tables.reflectance.texels.size(), 3u);
    // Saunderson's inner reflectance of n = 1.5 is 0.596 (Judd 1942, J. Res. NBS 29, 329).
    for (const float channel : tables.reflectance.texels) EXPECT_NEAR(channel, 0.596, 5e-4);
}

TEST(InnerTables, AgreeWithTheFilmSeenFromAbove)
{
    for (const std::complex<double> n : {std::complex<double>{2.3, 0.0}, {1.8, 0.4}}) {
        const FilmTableRequest request = test::on_glass(n);
        const InnerTables tables = bake_inner_tables(request, 8);
        ASSERT_EQ(tables.transmittance.texels.size(), 24u);
        for (const int row : {0, 3, 7})
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const double value = tables.transmittance.y.at(row);
                const auto at = 3 * static_cast<std::size_t>(row) + channel;
                EXPECT_NEAR(tables.transmittance.texels[at],
                            transmitted_from_above(request, value, channel), 2e-5)
                    << n << ' ' << row;
            }
    }
}

TEST(InnerTables, ClearFilmsKeepAllLight)
{
    const InnerTables tables = bake_inner_tables(test::on_glass(2.3), 9);
    for (std::size_t i = 0; i < tables.reflectance.texels.size(); ++i)
        EXPECT_NEAR(tables.reflectance.texels[i] + tables.transmittance.texels[i], 1.0, 1e-6);
    EXPECT_GT(tables.reflectance.error_max, 0.0);
}

TEST(InnerTables, AbsorbingFilmsDoNot)
{
    const InnerTables tables = bake_inner_tables(test::on_glass({1.8, 0.4}), 3);
    EXPECT_LT(tables.reflectance.texels[6] + tables.transmittance.texels[6], 0.7F);
}

TEST(InnerTables, SubstrateBelowTheAmbientHasNoTotalReflection)
{
    const auto water_on_air = test::request(constant(1.33), {}, constant(1.0), std::nullopt);
    // Judd 1942 for light that meets n = 1.33 from the air: 0.066.
    for (const float channel : bake_inner_tables(water_on_air, 1).reflectance.texels)
        EXPECT_NEAR(channel, 0.066, 5e-4);
}

TEST(InnerTables, SeenFromBelowKeepsTheVaryingLayer)
{
    auto asked =
        test::request(constant(1.0), {{constant(2.0), 10.0, true}, {constant(1.4), 20.0, true}},
                      constant(1.5), Variation{0, 1.0, 2.0});
    const FilmTableRequest below = seen_from_below(asked);
    EXPECT_EQ(below.stack.ambient[0], 1.5);
    EXPECT_EQ(below.stack.substrate[0], 1.0);
    EXPECT_EQ(below.stack.layers[1].thickness_nm, 10.0);
    EXPECT_EQ(below.variation->layer, 1u);
}

TEST(InnerTables, RefusesWhatTheTablesRefuse)
{
    FilmTableRequest wrong = test::on_glass(2.0);
    wrong.variation = Variation{3, 0.0, 1.0};
    EXPECT_THROW(static_cast<void>(bake_inner_tables(wrong, 4)), InputError);
}

}  // namespace
}  // namespace nacre::lut
