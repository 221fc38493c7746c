// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_tables.h"

#include <gtest/gtest.h>

#include <cmath>

#include "films.h"
#include "nacre/optics/microfacet.h"
#include "rough_truth.h"

namespace nacre::lut {
namespace {

using test::constant;

/// 100 … 400 nm of a clear oxide on a metal.
FilmTableRequest oxide_on_metal()
{
    return test::request(constant(1.0), {{constant(2.2), 100.0, true}}, constant({2.7, 3.3}),
                         Variation{0, 100.0, 400.0});
}

spectral::Vec3 texel(const Table& table, int slice, int x, int y)
{
    const int width = table.x.texels / table.slices;
    const auto i = static_cast<std::size_t>(3 * (y * table.x.texels + slice * width + x));
    return {table.texels[i], table.texels[i + 1], table.texels[i + 2]};
}

TEST(RoughTables, SlicesLieSideBySide)
{
    const FilmTableRequest request = oxide_on_metal();
    const FilmTables smooth = bake_film_tables(request);
    const RoughTables rough = bake_rough_tables(request, smooth);
    const Table& table = rough.reflectance;
    EXPECT_EQ(table.name(), "R_rough");
    EXPECT_EQ(table.slices, kRoughSlices);
    EXPECT_EQ(table.texel_bits, kRoughTexelBits);
    for (const float texel : table.texels)
        ASSERT_EQ(static_cast<double>(texel),
                  rounded_texel(static_cast<double>(texel), kRoughTexelBits));
    EXPECT_EQ(table.x.texels % kRoughSlices, 0);
    EXPECT_FALSE(rough.transmittance);
    EXPECT_LT(table.texels.size(), smooth.reflectance.texels.size());
    std::printf("smooth %d x %d, rough %d x %d, dE00 mean %.3f max %.3f\n",
                smooth.reflectance.x.texels, smooth.reflectance.y.texels, table.x.texels,
                table.y.texels, table.error_mean, table.error_max);
    EXPECT_LT(table.error_mean, 0.15);
    EXPECT_LT(table.error_max, 1.5);
}

/// Tint times albedo half-way between slices, as shaders mix them, of a metal that absorbs nothing:
/// the mean over a sphere in even light is 1 but for what interpolation leaves.
TEST(RoughTables, NoLightIsMadeBetweenSlices)
{
    const FilmTableRequest request =
        test::request(constant(1.0), {}, constant({1e-9, 5.0}), std::nullopt);
    const Table table = bake_rough_tables(request, bake_film_tables(request)).reflectance;
    const int width = table.x.texels / table.slices;
    for (int low = 1; low < kRoughSlices; ++low) {
        const double slice = low + 0.5, roughness = slice / kRoughSlices;
        const double share = slice_share(slice, low);
        double sum = 0.0, weights = 0.0;
        for (int x = 1; x < width; ++x) {
            const double cos_theta = static_cast<double>(x) / (width - 1);
            const double albedo = optics::ggx_albedo(cos_theta, roughness * roughness);
            const double tint =
                std::lerp(texel(table, low - 1, x, 0)[1], texel(table, low, x, 0)[1], share);
            sum += cos_theta * albedo * tint;
            weights += cos_theta;
        }
        EXPECT_NEAR(sum / weights, 1.0, 2.5e-3) << "roughness " << roughness;
    }
}

/// The whole of the fast technique, between the texels too, against light that walks.
TEST(RoughTables, TintedLobesAgreeWithLightThatWalks)
{
    const FilmTableRequest request = oxide_on_metal();
    const FilmTables smooth = bake_film_tables(request);
    const Table table = bake_rough_tables(request, smooth).reflectance;
    test::Errors errors;
    for (const int row : {2, table.y.texels / 2, table.y.texels - 3}) {
        const test::RoughTruth truth(request, table.y.at(row));
        for (const int slice : {1, 4, 6, 8})
            for (const double along : {0.3, 0.6, 0.95}) {
                const int width = table.x.texels / table.slices;
                const int x = static_cast<int>(std::lround(along * (width - 1)));
                const double cos_theta = static_cast<double>(x) / (width - 1);
                const double roughness = (slice + 1.0) / kRoughSlices;
                const double alpha = roughness * roughness;
                const double albedo = optics::ggx_albedo(cos_theta, alpha);
                spectral::Vec3 colour = texel(table, slice, x, row);
                for (double& channel : colour) channel *= albedo;
                errors.add(test::delta_e(request, colour,
                                         truth.albedo(cos_theta, {alpha, alpha}, 20'000).all));
            }
    }
    std::printf("dE00 mean %.3f max %.3f\n", errors.mean(), errors.max);
    EXPECT_LT(errors.mean(), 1.0);
}

TEST(RoughTables, ClearWallsKeepAllLight)
{
    auto request = test::request(constant(1.0), {{constant(1.33), 100.0, true}}, constant(1.0),
                                 Variation{0, 100.0, 600.0});
    request.transmittance = true;
    const FilmTables smooth = bake_film_tables(request);
    const RoughTables all = bake_rough_tables(request, smooth);
    const int width = all.reflectance.x.texels / kRoughSlices;
    std::vector<double> albedo;
    for (int column = 0; column < all.reflectance.x.texels; ++column) {
        const double roughness = (column / width + 1.0) / kRoughSlices;
        albedo.push_back(optics::ggx_albedo(static_cast<double>(column % width) / (width - 1),
                                            roughness * roughness));
    }
    // To 1e-5 but for rounding: each texel by up to half a step, all together by nothing.
    double lost = 0.0;
    for (std::size_t i = 0; i < all.reflectance.texels.size(); ++i) {
        const int column = static_cast<int>(i / 3) % all.reflectance.x.texels;
        const double E = albedo[static_cast<std::size_t>(column)];
        const double kept = E * all.reflectance.texels[i] + all.transmittance->texels[i];
        ASSERT_NEAR(kept, 1.0,
                    test::half_step(all.transmittance->texels[i], kRoughTexelBits) + 1e-5);
        lost += 1.0 - kept;
    }
    EXPECT_NEAR(lost / static_cast<double>(all.reflectance.texels.size()), 0.0, 1e-5);
}

}  // namespace
}  // namespace nacre::lut
