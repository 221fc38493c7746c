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
        SCOPED_TRACE(table.name + " of " + std::to_string(table.x.texels) + "x" +
                     std::to_string(table.y.texels));
        EXPECT_LE(table.error_max, asked.tolerance);
        EXPECT_LE(measured.max, table.error_max * 1.02);
        EXPECT_GE(measured.max, table.error_max * 0.3);
        EXPECT_NEAR(measured.mean, table.error_mean, 0.3 * table.error_mean);
    };
    check(tables.reflectance, false);
    if (tables.transmittance) check(*tables.transmittance, true);
}

TEST(FilmTableError, OfOneFilm)
{
    expect_honest(test::soap_film());
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
