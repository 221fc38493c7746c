// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::lut {
namespace {

TEST(Axis, EdgeTexelsHoldTheEnds)
{
    for (const int texels : {2, 3, 49, 4096}) {
        const Axis axis{"thickness_nm", "nm", 0.1, 733.3, texels};
        EXPECT_EQ(axis.at(0), 0.1);
        EXPECT_EQ(axis.at(texels - 1), 733.3);
    }
}

TEST(Axis, IsLinearAndAscends)
{
    const Axis axis{"cos_theta", "1", 0.0, 1.0, 65};
    for (int i = 0; i < 65; ++i) EXPECT_EQ(axis.at(i), i / 64.0);
    const Axis odd{"thickness_nm", "nm", 20.0, 1500.0, 1000};
    for (int i = 1; i < 1000; ++i) {
        EXPECT_GT(odd.at(i), odd.at(i - 1));
        EXPECT_NEAR(odd.at(i) - odd.at(i - 1), 1480.0 / 999.0, 1e-12);
    }
}

TEST(Axis, OfOneTexelHoldsItsMinimum)
{
    EXPECT_EQ((Axis{"thickness_nm", "nm", 3.0, 9.0, 1}.at(0)), 3.0);
}

TEST(RoundedTexel, IsTheNearestOfSoManyBits)
{
    EXPECT_EQ(rounded_texel(0.7, 3), 11.0 / 16.0);
    EXPECT_EQ(rounded_texel(-0.7, 3), -11.0 / 16.0);
    EXPECT_EQ(rounded_texel(0.99, 3), 1.0);
    EXPECT_EQ(rounded_texel(1.0, 9), 1.0);
    EXPECT_EQ(rounded_texel(0.0, 9), 0.0);
    for (const int bits : {9, 13}) {
        for (double value = 1.0 / 32.0; value < 3.0; value *= 1.01)
            EXPECT_LE(std::abs(rounded_texel(value, bits) / value - 1.0), std::ldexp(0.5, -bits));
    }
}

TEST(RoundedTexel, HasEqualStepsInTheDark)
{
    const double step = std::ldexp(1.0, -5 - 9);
    for (double value = 0.0; value < 1.0 / 32.0; value += 1.7e-5) {
        const double rounded = rounded_texel(value, 9);
        EXPECT_LE(std::abs(rounded - value), 0.5 * step);
        EXPECT_EQ(rounded, step * std::round(rounded / step));
    }
}

}  // namespace
}  // namespace nacre::lut
