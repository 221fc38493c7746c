// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/film_table.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "films.h"
#include "nacre/optics/multilayer.h"
#include "support/expect.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

void expect_near(const Vec3& actual, const Vec3& expected, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance);
}

/// The sum over 471 wavelengths, one stack at a time.
FilmColour colour_one_by_one(const FilmTableRequest& asked, double cosine, double value)
{
    spectral::Sampled R, T;
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        optics::FilmStack stack{asked.stack.ambient[i], {}, asked.stack.substrate[i]};
        for (std::size_t j = 0; j < asked.stack.layers.size(); ++j) {
            const SampledLayer& layer = asked.stack.layers[j];
            double d_nm = layer.thickness_nm;
            if (asked.variation && asked.variation->layer == j) d_nm = value;
            if (asked.variation && !asked.variation->layer && layer.coherent) d_nm *= value;
            stack.layers.push_back({layer.n[i], d_nm, layer.coherent});
        }
        const auto power = stack_power_unpolarised(stack, cosine, spectral::wavelength_nm(i));
        R[i] = power.R;
        T[i] = power.T;
    }
    return {asked.weights.apply(R), asked.weights.apply(T)};
}

TEST(FilmTable, ExactColourIsTheSumOverTheSpectrum)
{
    for (const FilmTableRequest& asked :
         {test::soap_film(), test::anodised(), test::mirror(), test::coated_pane()}) {
        for (const double cosine : {1.0, 0.5, 0.03}) {
            for (const double share : {0.0, 0.37, 1.0}) {
                const double value =
                    asked.variation->min + share * (asked.variation->max - asked.variation->min);
                const FilmColour exact = exact_film_colour(asked, cosine, value);
                const FilmColour expected = colour_one_by_one(asked, cosine, value);
                expect_near(exact.reflectance, expected.reflectance, 1e-11);
                expect_near(exact.transmittance, expected.transmittance, 1e-11);
            }
        }
    }
}

TEST(FilmTable, WithoutMeasuringTheTexelsAreTheSame)
{
    for (FilmTableRequest asked : {test::soap_film(), test::mirror()}) {
        asked.size = {9, 7};
        asked.transmittance = true;
        const FilmTables measured = bake_film_tables(asked);
        asked.measure_error = false;
        const FilmTables quick = bake_film_tables(asked);
        ASSERT_EQ(quick.reflectance.texels.size(), measured.reflectance.texels.size());
        for (std::size_t i = 0; i < quick.reflectance.texels.size(); ++i) {
            // Phases are marched in other steps: a rounding before the texel is stored.
            EXPECT_NEAR(quick.reflectance.texels[i], measured.reflectance.texels[i], 1e-6F);
            EXPECT_NEAR(quick.transmittance->texels[i], measured.transmittance->texels[i], 1e-6F);
        }
        EXPECT_TRUE(std::isnan(quick.reflectance.error_max));
        EXPECT_TRUE(std::isnan(quick.transmittance->error_mean));
        EXPECT_TRUE(std::isfinite(measured.reflectance.error_max));
    }
    FilmTableRequest sizeless = test::soap_film();
    sizeless.measure_error = false;
    EXPECT_THROW((void)bake_film_tables(sizeless), InputError);
}

TEST(FilmTable, TexelsAreTheExactColoursOfTheirCentres)
{
    for (FilmTableRequest asked : {test::soap_film(), test::mirror(), test::coated_pane()}) {
        asked.size = {9, 7};
        asked.transmittance = true;
        const FilmTables tables = bake_film_tables(asked);
        const Table& R = tables.reflectance;
        ASSERT_EQ(R.x.texels, 9);
        ASSERT_EQ(R.y.texels, 7);
        ASSERT_EQ(R.texels.size(), 9U * 7U * 3U);
        for (int row = 0; row < 7; ++row) {
            for (int column = 0; column < 9; ++column) {
                const double x = R.x.at(column), y = R.y.at(row);
                const FilmColour exact = exact_film_colour(asked, x, y);
                expect_near(test::read(R, x, y), exact.reflectance, 1e-6);
                expect_near(test::read(*tables.transmittance, x, y), exact.transmittance, 1e-6);
            }
        }
    }
}

TEST(FilmTable, SaysWhatItsAxesAre)
{
    auto asked = test::soap_film();
    asked.size = {5, 3};
    const FilmTables tables = bake_film_tables(asked);
    EXPECT_EQ(tables.reflectance.name(), "R");
    EXPECT_EQ(tables.reflectance.quantity, "reflectance");
    EXPECT_EQ(tables.transmittance->name(), "T");
    EXPECT_EQ(tables.transmittance->quantity, "transmittance");
    const Axis &x = tables.reflectance.x, &y = tables.reflectance.y;
    EXPECT_EQ(x.name, "cos_theta");
    EXPECT_EQ(x.unit, "1");
    EXPECT_EQ(x.at(0), 0.0);
    EXPECT_EQ(x.at(4), 1.0);
    EXPECT_EQ(y.name, "thickness_nm");
    EXPECT_EQ(y.unit, "nm");
    EXPECT_EQ(y.at(0), 20.0);
    EXPECT_EQ(y.at(2), 700.0);
    EXPECT_EQ(tables.reflectance.channels, (std::vector<std::string>{"R", "G", "B"}));

    auto scaled = test::mirror();
    scaled.size = {5, 3};
    EXPECT_EQ(bake_film_tables(scaled).reflectance.y.name, "thickness_scale");
    EXPECT_EQ(bake_film_tables(scaled).reflectance.y.unit, "1");
}

TEST(FilmTable, HasOneRowWhereOnlyTheAngleVaries)
{
    auto asked = test::anodised();
    asked.variation.reset();
    const Table table = bake_film_tables(asked).reflectance;
    EXPECT_EQ(table.y.texels, 1);
    EXPECT_LE(table.error_max, asked.tolerance);
    expect_near(test::read(table, 1.0, 0.0), colour_one_by_one(asked, 1.0, 0.0).reflectance, 1e-6);
}

TEST(FilmTable, GrowsWhenTheToleranceShrinks)
{
    auto asked = test::anodised();
    int width = 0, height = 0;
    for (const double tolerance : {2.0, 0.3, 0.04}) {
        asked.tolerance = tolerance;
        const Table table = bake_film_tables(asked).reflectance;
        EXPECT_LE(table.error_max, tolerance);
        EXPECT_LE(table.error_mean, table.error_max);
        EXPECT_GE(table.x.texels, width);
        EXPECT_GT(table.x.texels * table.y.texels, width * height);
        width = table.x.texels;
        height = table.y.texels;
    }
}

TEST(FilmTable, StatesTheErrorOfAForcedSize)
{
    auto asked = test::anodised();
    asked.size = {17, 9};
    const double coarse = bake_film_tables(asked).reflectance.error_max;
    asked.size = {33, 17};
    const double fine = bake_film_tables(asked).reflectance.error_max;
    EXPECT_GT(coarse, asked.tolerance);
    EXPECT_NEAR(coarse / fine, 4.0, 1.5);  // the square of the step
}

// Whatever the threads do, the bytes are the same.
TEST(FilmTable, DoesNotDependOnTheNumberOfThreads)
{
    for (FilmTableRequest asked : {test::soap_film(), test::coated_pane()}) {
        asked.size = {33, 40};
        const auto bake = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return bake_film_tables(asked);
        };
        const FilmTables one = bake(1), several = bake(4);
        EXPECT_EQ(one.reflectance.texels, several.reflectance.texels);
        EXPECT_EQ(one.reflectance.error_max, several.reflectance.error_max);
        EXPECT_EQ(one.reflectance.error_mean, several.reflectance.error_mean);
        EXPECT_EQ(one.transmittance.has_value(), several.transmittance.has_value());
        if (one.transmittance) {
            EXPECT_EQ(one.transmittance->texels, several.transmittance->texels);
        }
    }
}

TEST(FilmTable, NothingThereIsWhiteInTransmission)
{
    const IndexOnGrid glass = test::constant(1.5);
    auto asked = test::request(glass, {{glass, 100.0, true}}, glass, Variation{0, 0.0, 500.0});
    asked.transmittance = true;
    for (const double cosine : {1.0, 0.4, 0.0}) {
        const FilmColour colour = exact_film_colour(asked, cosine, 250.0);
        expect_near(colour.transmittance, {1.0, 1.0, 1.0}, 1e-12);
        expect_near(colour.reflectance, {}, 1e-12);
    }
}

TEST(FilmTable, GrazingIncidenceIsAPerfectMirror)
{
    for (const FilmTableRequest& asked : {test::soap_film(), test::anodised(), test::mirror()}) {
        const FilmColour colour = exact_film_colour(asked, 0.0, asked.variation->max);
        expect_near(colour.reflectance, {1.0, 1.0, 1.0}, 1e-6);
        expect_near(colour.transmittance, {}, 1e-6);
    }
}

// A saturated film lies outside the gamut; its negative channel is data.
TEST(FilmTable, DoesNotClip)
{
    auto asked = test::mirror();
    asked.size = {9, 5};
    const Table table = bake_film_tables(asked).reflectance;
    EXPECT_LT(*std::min_element(table.texels.begin(), table.texels.end()), -0.01F);
}

TEST(FilmTable, ReportsProgressAndObeysACancel)
{
    auto asked = test::anodised();
    double last = 0.0;
    asked.progress = [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1.0);
        last = done;
        return true;
    };
    static_cast<void>(bake_film_tables(asked));
    EXPECT_GT(last, 0.8);
    asked.progress = [](double) { return false; };
    EXPECT_EQ(nacre::test::input_error_of([&] { static_cast<void>(bake_film_tables(asked)); }),
              "cancelled");
}

TEST(FilmTable, SaysHowFarItGotWhereTheToleranceIsOutOfReach)
{
    auto asked = test::soap_film();
    asked.max_texels = 8;
    EXPECT_INPUT_ERROR(static_cast<void>(bake_film_tables(asked)),
                       "tolerance: a table of at most 8 texels per axis reaches ΔE00");
}

TEST(FilmTable, RefusesWhatMakesNoSense)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto with = [](auto&& change) {
        auto asked = test::anodised();
        asked.size = {5, 3};
        change(asked);
        return nacre::test::input_error_of([&] { static_cast<void>(bake_film_tables(asked)); });
    };
    using Asked = FilmTableRequest;
    EXPECT_EQ(with([](Asked& a) {
                  a.stack.layers[0].n[100] = {1.5, -0.1};
              }),
              "n[1]: imaginary part must be ≥ 0 (media with gain are not supported) (at 460 nm)");
    EXPECT_EQ(with([](Asked& a) { a.stack.substrate[0] = 0.0; }),
              "n[2]: real part must be > 0 (at 360 nm)");
    EXPECT_EQ(with([](Asked& a) {
                  a.stack.ambient[470] = {1.0, 0.1};
              }),
              "n[0]: the ambient must not absorb (imaginary part 0) (at 830 nm)");
    EXPECT_EQ(with([&](Asked& a) { a.stack.layers[0].thickness_nm = nan; }),
              "d_nm[0]: must be finite and ≥ 0 (at 360 nm)");
    EXPECT_EQ(with([](Asked& a) { a.stack.layers.assign(65, a.stack.layers[0]); }),
              "d_nm[64]: at most 64 layers (at 360 nm)");
    EXPECT_EQ(with([](Asked& a) { a.variation->max = 20.0; }),
              "variation: must have 0 ≤ min < max, both finite (got 20 and 20)");
    EXPECT_EQ(with([](Asked& a) { a.variation->min = -1.0; }),
              "variation: must have 0 ≤ min < max, both finite (got -1 and 160)");
    EXPECT_EQ(with([&](Asked& a) { a.variation->max = nan; }),
              "variation: must have 0 ≤ min < max, both finite (got 20 and nan)");
    EXPECT_EQ(with([](Asked& a) { a.variation->layer = 1; }),
              "variation: must name one of the 1 layers (got layer[1])");
    EXPECT_EQ(with([](Asked& a) { a.tolerance = 0.0; }), "tolerance: must be > 0 (got 0)");
    EXPECT_EQ(with([&](Asked& a) { a.tolerance = nan; }), "tolerance: must be > 0 (got nan)");
    EXPECT_EQ(with([](Asked& a) { a.max_texels = 1; }), "max_texels: must be ≥ 2 (got 1)");
    EXPECT_EQ(with([](Asked& a) {
                  a.size = {1, 3};
              }),
              "size: must be 2…16384 texels wide and 2…16384 high (got 1x3)");
    EXPECT_EQ(with([](Asked& a) {
                  a.variation.reset();
                  a.size = {5, 2};
              }),
              "size: must be 2…16384 texels wide and 1…1 high (got 5x2)");
}

}  // namespace
}  // namespace nacre::lut
