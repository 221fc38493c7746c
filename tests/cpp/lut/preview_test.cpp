// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "films.h"
#include "nacre/spectral/colour.h"

namespace nacre::lut {
namespace {

TexelSize size_of(const Table& table)
{
    return {table.x.texels, table.y.texels};
}

struct Difference {
    double mean = 0.0, max = 0.0;
};

/// Of texels, those of grazing light left out.
Difference difference(const Table& a, const Table& b, const FilmTableRequest& request)
{
    EXPECT_EQ(a.role, b.role);
    EXPECT_EQ(a.texels.size(), b.texels.size());
    const auto colour = [](const Table& table, std::size_t i) {
        return spectral::Vec3{table.texels[i], table.texels[i + 1], table.texels[i + 2]};
    };
    Difference result;
    std::size_t count = 0;
    const auto width = static_cast<std::size_t>(a.x.texels / a.slices);
    for (std::size_t i = 0; i < a.texels.size() / 3; ++i) {
        if (width > 1 && static_cast<double>(i % width) < 0.1 * static_cast<double>(width))
            continue;
        const double error = test::delta_e(request, colour(a, 3 * i), colour(b, 3 * i));
        result.mean += error;
        result.max = std::max(result.max, error);
        ++count;
    }
    result.mean /= static_cast<double>(count);
    return result;
}

TEST(Preview, IsCloseToTheBake)
{
    FilmTableRequest closed_form = test::soap_film();
    closed_form.technique = Technique{.model = optics::FilmModel::recursion};
    for (const FilmTableRequest& request :
         {test::soap_film(), closed_form, test::anodised(), test::mirror(), test::coated_pane()}) {
        const FilmTables baked = bake_film_tables(request);
        const FilmTables quick = preview_film_tables(request, size_of(baked.reflectance));
        const Difference R = difference(quick.reflectance, baked.reflectance, request);
        std::printf("R %d x %d: dE00 mean %.3f max %.3f\n", baked.reflectance.x.texels,
                    baked.reflectance.y.texels, R.mean, R.max);
        EXPECT_LT(R.mean, 0.2);
        EXPECT_LT(R.max, 2.5);
        EXPECT_TRUE(std::isnan(quick.reflectance.error_max));
        ASSERT_EQ(quick.transmittance.has_value(), baked.transmittance.has_value());
        if (!baked.transmittance) continue;
        EXPECT_LT(difference(*quick.transmittance, *baked.transmittance, request).mean, 0.2);
    }
}

/// In resonance at grazing incidence single precision would find 0/0.
TEST(Preview, ThickFilmsHaveAColourAtGrazingIncidence)
{
    FilmTableRequest request = test::soap_film();
    request.variation = Variation{0, 0.0, 1500.0};
    const FilmTables quick = preview_film_tables(request, {170, 1129});
    for (const Table& table : {quick.reflectance, *quick.transmittance})
        EXPECT_TRUE(
            std::ranges::all_of(table.texels, [](float value) { return std::isfinite(value); }));
}

TEST(Preview, RoughTablesAreCloseToTheBake)
{
    for (const FilmTableRequest& request : {test::soap_film(), test::anodised(), test::mirror()}) {
        const FilmTables smooth = bake_film_tables(request);
        const RoughTables baked = bake_rough_tables(request, smooth);
        const RoughTables quick = preview_rough_tables(
            preview_film_tables(request, size_of(smooth.reflectance)), size_of(baked.reflectance));
        const Difference R = difference(quick.reflectance, baked.reflectance, request);
        std::printf("R_rough %d x %d: dE00 mean %.3f max %.3f\n", baked.reflectance.x.texels,
                    baked.reflectance.y.texels, R.mean, R.max);
        EXPECT_LT(R.mean, 1.5);
        EXPECT_LT(R.max, 8.0);
        if (baked.transmittance) {
            EXPECT_LT(difference(*quick.transmittance, *baked.transmittance, request).mean, 1.5);
        }
        EXPECT_FALSE(quick.further);
    }
}

TEST(Preview, RoughGlassIsCloseToTheBake)
{
    constexpr double kIndex = 1.52;
    const FilmTableRequest request = test::mirror();
    const FilmTables smooth = bake_film_tables(request);
    const RoughTables baked = bake_rough_glass_tables(request, smooth, kIndex);
    const RoughTables quick =
        preview_rough_glass_tables(preview_film_tables(request, size_of(smooth.reflectance)),
                                   kIndex, size_of(baked.reflectance));
    EXPECT_EQ(quick.reflectance.sides, kGlassSides);
    EXPECT_LT(difference(quick.reflectance, baked.reflectance, request).mean, 1.0);
    EXPECT_LT(difference(*quick.transmittance, *baked.transmittance, request).mean, 1.0);
}

TEST(Preview, AMirrorStaysWhiteHoweverRough)
{
    FilmTableRequest request =
        test::request(test::constant(1.0), {}, test::constant({1e-4, 90.0}), {});
    const RoughTables rough = preview_rough_tables(preview_film_tables(request, {33, 1}), {340, 1});
    // R E + further = 1, divided by E: what the lobe's own albedo E takes away comes back.
    const Table& table = rough.reflectance;
    EXPECT_GT(*std::ranges::min_element(table.texels), 0.99F);
    EXPECT_LT(table.texels[3 * 33], 1.1F);
}

TEST(Preview, InnerTablesAreCloseToTheBake)
{
    FilmTableRequest request = test::soap_film();
    request.stack.substrate = test::constant(1.5);
    const InnerTables baked = bake_inner_tables(request, 200);
    const InnerTables quick = preview_inner_tables(request, 200);
    ASSERT_EQ(quick.reflectance.y.texels, 200);
    for (std::size_t i = 0; i < baked.reflectance.texels.size(); ++i) {
        EXPECT_NEAR(quick.reflectance.texels[i], baked.reflectance.texels[i], 2e-3);
        EXPECT_NEAR(quick.transmittance.texels[i], baked.transmittance.texels[i], 2e-3);
    }
}

}  // namespace
}  // namespace nacre::lut
