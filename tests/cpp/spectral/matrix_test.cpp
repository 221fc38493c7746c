// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/matrix.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

constexpr Mat3 kMatrix = {{{2, 0, 1}, {1, 3, 0}, {0, 4, 5}}};

// By hand: rows times columns.
TEST(Matrix, MultipliesRowsByColumns)
{
    EXPECT_EQ(multiply(kMatrix, Vec3{1, 2, 3}), (Vec3{5, 7, 23}));
    EXPECT_EQ(multiply(kMatrix, Mat3{{{1, 0, 2}, {0, 1, 0}, {3, 0, 1}}}),
              (Mat3{{{5, 0, 5}, {1, 3, 2}, {15, 4, 5}}}));
}

TEST(Matrix, TurnsRowsIntoColumns)
{
    EXPECT_EQ(transposed(kMatrix), (Mat3{{{2, 1, 0}, {0, 3, 4}, {1, 0, 5}}}));
}

// Along the first row: 2 (3·5 − 0·4) − 0 + 1 (1·4 − 3·0) = 34.
TEST(Matrix, HasADeterminant)
{
    EXPECT_EQ(determinant(kMatrix), 34.0);
    EXPECT_EQ(determinant({{{1, 2, 3}, {2, 4, 6}, {0, 1, 0}}}), 0.0);
}

TEST(Matrix, TimesItsInverseIsOne)
{
    const Mat3 one = multiply(inverse(kMatrix), kMatrix);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            EXPECT_NEAR(one[row][column], row == column ? 1.0 : 0.0, 1e-15);
    EXPECT_EQ(inverse(diagonal({2, 4, 8})), diagonal({0.5, 0.25, 0.125}));
}

}  // namespace
}  // namespace nacre::spectral
