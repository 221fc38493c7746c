// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "films.h"
#include "nacre/lut/film_table.h"

// A table says how wrong it is between its texels. Here that is found out again, elsewhere.

namespace nacre::lut {
namespace {

struct Measured {
    double max = 0.0, mean = 0.0;
};

/// Random points where the error counts; for the largest error the middles of cells as well, where
/// bilinear interpolation is worst.
Measured measure(const FilmTableRequest& asked, const Table& table, bool transmittance)
{
    constexpr double kLeastCosine = 0.05;
    constexpr int kProbes = 600;
    Measured measured;
    double sum = 0.0;
    const auto probe = [&](double x, double y) {
        const FilmColour exact = exact_film_colour(asked, x, y);
        const double error = test::delta_e(asked, test::read(table, x, y),
                                           transmittance ? exact.transmittance : exact.reflectance);
        measured.max = std::max(measured.max, error);
        sum += error;
    };
    std::mt19937 engine(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    for (int i = 0; i < kProbes; ++i)
        probe(between(kLeastCosine, 1.0), between(table.y.min, table.y.max));
    measured.mean = sum / kProbes;
    for (int i = 0; i < kProbes; ++i) {
        const int column = static_cast<int>(between(0.0, table.x.texels - 1));
        const int row = static_cast<int>(between(0.0, table.y.texels - 1));
        const double x = 0.5 * (table.x.at(column) + table.x.at(column + 1));
        if (x >= kLeastCosine) probe(x, 0.5 * (table.y.at(row) + table.y.at(row + 1)));
    }
    return measured;
}

void expect_honest(const FilmTableRequest& asked)
{
    const FilmTables tables = bake_film_tables(asked);
    ASSERT_EQ(tables.transmittance.has_value(), asked.transmittance);
    const auto check = [&](const Table& table, bool transmittance) {
        const Measured measured = measure(asked, table, transmittance);
        SCOPED_TRACE(table.name() + " of " + std::to_string(table.x.texels) + "x" +
                     std::to_string(table.y.texels));
        EXPECT_LE(table.error_max, asked.tolerance);
        EXPECT_LE(measured.max, table.error_max * 1.02);
        EXPECT_GE(measured.max, table.error_max * 0.3);
        EXPECT_NEAR(measured.mean, table.error_mean, 0.3 * table.error_mean);
    };
    check(tables.reflectance, false);
    if (tables.transmittance) check(*tables.transmittance, true);
}

/// Of reflectance, over the picture of a sphere of one thickness: the area goes with cosθ.
double mean_on_a_sphere(const FilmTableRequest& asked, const Table& table, double thickness_nm)
{
    constexpr int kCosines = 1000;
    double sum = 0.0, area = 0.0;
    for (int i = 0; i < kCosines; ++i) {
        const double cosine = 0.05 + 0.95 * (i + 0.5) / kCosines;
        const auto exact = exact_film_colour(asked, cosine, thickness_nm).reflectance;
        sum += cosine * test::delta_e(asked, test::read(table, cosine, thickness_nm), exact);
        area += cosine;
    }
    return sum / area;
}

void expect_each_row_right_on_average(FilmTableRequest asked)
{
    asked.transmittance = false;
    const Table table = bake_film_tables(asked).reflectance;
    const int steps = 2 * table.y.texels - 2;
    double largest = 0.0;
    for (int i = 0; i < 24; ++i) {
        const int half_row = steps * i / 23;
        const double along = static_cast<double>(half_row) / steps;
        const double nm = table.y.min + along * (table.y.max - table.y.min);
        largest = std::max(largest, mean_on_a_sphere(asked, table, nm));
    }
    EXPECT_LE(largest, 0.0905 * asked.tolerance);
    EXPECT_GE(largest, 0.01 * asked.tolerance);
}

TEST(FilmTableError, EachRowIsRightOnAverage)
{
    expect_each_row_right_on_average(test::soap_film());
    expect_each_row_right_on_average(test::anodised());
}

TEST(FilmTableError, OfOneFilm)
{
    expect_honest(test::soap_film());
}

TEST(FilmTableError, OfRoundedTexels)
{
    for (const int bits : {13, 7}) {
        auto asked = test::anodised();
        asked.texel_bits = bits;
        asked.size = {{40, 200}};
        asked.tolerance = 10.0;
        expect_honest(asked);
        const Table table = bake_film_tables(asked).reflectance;
        EXPECT_EQ(table.texel_bits, bits);
        for (const float texel : table.texels)
            ASSERT_EQ(static_cast<double>(texel), rounded_texel(static_cast<double>(texel), bits));
    }
}

TEST(FilmTableError, OfOneFilmAtAFinerTolerance)
{
    auto asked = test::anodised();
    asked.tolerance = 0.03;
    expect_honest(asked);
}

TEST(FilmTableError, OfAMirrorThatIsScaled)
{
    expect_honest(test::mirror());
}

TEST(FilmTableError, OfAFilmOnAPane)
{
    expect_honest(test::coated_pane());
}

}  // namespace
}  // namespace nacre::lut
