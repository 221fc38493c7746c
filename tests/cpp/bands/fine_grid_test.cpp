// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/fine_grid.h"

#include <gtest/gtest.h>

namespace nacre::bands {
namespace {

TEST(FineGrid, StandsInTheMiddleOfTenthsOfANanometre)
{
    const std::vector<double>& grid = fine_grid();
    ASSERT_EQ(grid.size(), kFineWavelengths);
    EXPECT_DOUBLE_EQ(grid.front(), 360.05);
    EXPECT_DOUBLE_EQ(grid.back(), 829.95);
    EXPECT_DOUBLE_EQ(grid[1234], fine_nm(1234));
    double square = 0.0;
    for (const double nm : grid) square += nm * nm * kStepNm;
    EXPECT_NEAR(square / ((830.0 * 830.0 * 830.0 - 360.0 * 360.0 * 360.0) / 3.0), 1.0, 1e-8);
}

}  // namespace
}  // namespace nacre::bands
