// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/gamut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/expect.h"

namespace nacre::spectral {
namespace {

constexpr GamutMapping kAll[] = {GamutMapping::clip, GamutMapping::desaturate, GamutMapping::scale};

Vec3 luminance()
{
    return colour_space("lin_rec709_scene").to_xyz_d65[1];
}

double dot(const Vec3& a, const Vec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void expect_near(const Vec3& actual, const Vec3& expected)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], 1e-15) << c;
}

TEST(Gamut, InsideNothingChanges)
{
    for (const Vec3& rgb : {Vec3{0, 0, 0}, {1, 1, 1}, {0.2, 0.7, 0.1}, {1, 0, 0}})
        for (const GamutMapping mapping : kAll)
            expect_near(map_to_gamut(rgb, mapping, luminance(), ColourOf::surface), rgb);
}

TEST(Gamut, KeptAsItIs)
{
    const Vec3 rgb = {-0.3, 1.7, 0.4};
    EXPECT_EQ(map_to_gamut(rgb, GamutMapping::keep, luminance(), ColourOf::surface), rgb);
}

TEST(Gamut, ByHand)
{
    const Vec3 rgb = {-0.2, 0.5, 2.0};
    expect_near(map_to_gamut(rgb, GamutMapping::clip, luminance(), ColourOf::surface),
                {0.0, 0.5, 1.0});
    expect_near(map_to_gamut(rgb, GamutMapping::scale, luminance(), ColourOf::surface),
                {0.0, 0.25, 1.0});
    // Equal weights: the grey is 0.4, and 4/5 of the way from it red reaches 0.
    constexpr double third = 1.0 / 3.0;
    expect_near(map_to_gamut({-0.1, 0.4, 0.9}, GamutMapping::desaturate, {third, third, third},
                             ColourOf::surface),
                {0.0, 0.4, 0.8});
}

TEST(Gamut, DesaturationKeepsLuminanceAndHue)
{
    std::mt19937 engine(1);
    const auto draw = [&engine] {
        return -0.6 + 2.2 * static_cast<double>(engine()) / 4294967296.0;
    };
    const Vec3 weights = luminance();
    int outside = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 rgb = {draw(), draw(), draw()};
        const double y = dot(weights, rgb);
        if (y <= 0.0 || y >= 1.0) continue;
        const Vec3 mapped = map_to_gamut(rgb, GamutMapping::desaturate, weights, ColourOf::surface);
        EXPECT_NEAR(dot(weights, mapped), y, 1e-14);
        // On the line from the grey: distances from it shrink by one factor.
        EXPECT_NEAR((mapped[0] - y) * (rgb[1] - y), (mapped[1] - y) * (rgb[0] - y), 1e-14);
        if (std::ranges::min(rgb) >= 0.0 && std::ranges::max(rgb) <= 1.0) continue;
        ++outside;
        // Just as far as needed: a channel ends at a face of the cube.
        EXPECT_LE(std::min(std::ranges::min(mapped), 1.0 - std::ranges::max(mapped)), 1e-14);
    }
    EXPECT_GT(outside, 500);
}

TEST(Gamut, EndsInsideFromAnywhere)
{
    for (const double a : {-1e6, -1.0, 0.0, 0.5, 3.0, 1e6}) {
        for (const double b : {-1e6, 0.3, 2.0}) {
            for (const GamutMapping mapping : kAll) {
                const Vec3 mapped =
                    map_to_gamut({a, b, 0.1}, mapping, luminance(), ColourOf::surface);
                EXPECT_GE(std::ranges::min(mapped), 0.0);
                EXPECT_LE(std::ranges::max(mapped), 1.0);
            }
        }
    }
}

/// Bright is not out of gamut: of a light of Y = 1 the chromaticity is kept, or comes to the edge
/// of the triangle on the straight way to white.
TEST(Gamut, LightsAreNotWashedOut)
{
    const auto desaturate = [](const Vec3& rgb) {
        return map_to_gamut(rgb, GamutMapping::desaturate, luminance(), ColourOf::light);
    };
    const auto& space = colour_space("lin_rec709_scene");
    const Vec3 bulb = {1.84534, 0.826049, 0.233317};  // illuminant A: doc/colour.md
    EXPECT_EQ(desaturate(bulb), bulb);
    EXPECT_EQ(desaturate({30.0, 12.0, 0.0}), (Vec3{30.0, 12.0, 0.0}));
    EXPECT_EQ(desaturate({-3.0, 0.1, 0.2}), (Vec3{}));

    // Sodium, xy = (0.5693, 0.4302): the way from white meets the edge from red to green.
    const double x = 0.5693, y = 0.4302;
    const Vec3 line = {x / y, 1.0, (1.0 - x - y) / y};
    Vec3 rgb{}, xyz{};
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = dot(space.from_xyz_d65[c], line);
    ASSERT_LT(rgb[2], -0.01);
    const Vec3 mapped = desaturate(rgb);
    for (std::size_t c = 0; c < 3; ++c) xyz[c] = dot(space.to_xyz_d65[c], mapped);
    // White (0.3127, 0.3290) + t (line − white), on (0.64, 0.33) + u (−0.34, 0.27), by Cramer.
    const double dx = x - 0.3127, dy = y - 0.3290;
    const double t = (0.27 * (0.64 - 0.3127) + 0.34 * (0.33 - 0.3290)) / (0.27 * dx + 0.34 * dy);
    const auto [mapped_x, mapped_y] = xyz_to_xy(xyz);
    EXPECT_NEAR(mapped[2], 0.0, 1e-15);
    EXPECT_NEAR(xyz[1], 1.0, 1e-12);
    EXPECT_NEAR(mapped_x, 0.3127 + t * dx, 1e-6);
    EXPECT_NEAR(mapped_y, 0.3290 + t * dy, 1e-6);
}

TEST(Gamut, NamesAreRead)
{
    EXPECT_EQ(gamut_mapping_from_name("desaturate"), GamutMapping::desaturate);
    EXPECT_INPUT_ERROR((void)gamut_mapping_from_name("compress"), "keep, clip, desaturate, scale");
}

TEST(Gamut, RangeOfAllColoursTogether)
{
    const std::vector<Vec3> colours = {{-0.5, 1.0, 2.0}, {4.0, 0.0, 0.25}};
    auto clamped = colours, shared = colours, kept = colours;
    map_range(clamped, RangeMapping::clamp);
    EXPECT_EQ(clamped, (std::vector<Vec3>{{0.0, 1.0, 1.0}, {1.0, 0.0, 0.25}}));
    map_range(shared, RangeMapping::normalise);
    EXPECT_EQ(shared, (std::vector<Vec3>{{-0.125, 0.25, 0.5}, {1.0, 0.0, 0.0625}}));
    map_range(kept, RangeMapping::none);
    EXPECT_EQ(kept, colours);
    std::vector<Vec3> black = {{0.0, -1.0, 0.0}};
    map_range(black, RangeMapping::normalise);
    EXPECT_EQ(black, (std::vector<Vec3>{{0.0, -1.0, 0.0}}));
    EXPECT_EQ(range_mapping_from_name("clamp"), RangeMapping::clamp);
    EXPECT_INPUT_ERROR((void)range_mapping_from_name("loud"),
                       "range: must be one of none, clamp, normalise (got 'loud')");
}

}  // namespace
}  // namespace nacre::spectral
