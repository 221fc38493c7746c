// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/tabulated_index.h"

#include <array>

#include "support/expect.h"

namespace nacre::spectral {
namespace {

const IndexTable kN{{0.4, 0.5, 0.8}, {1.6, 1.5, 1.4}};

TEST(TabulatedIndex, IsLinearBetweenRows)
{
    EXPECT_EQ(kN.at(0.4), 1.6);
    EXPECT_EQ(kN.at(0.8), 1.4);
    EXPECT_NEAR(kN.at(0.65), 1.45, 1e-15);
    EXPECT_EQ(kN.range_um(), (std::array{0.4, 0.8}));
}

TEST(MeasuredConstants, HoldWhereBothAreKnown)
{
    const IndexTable k{{0.3, 0.6}, {0.0, 0.3}};
    const auto medium = measured_constants({"mine", kN, k});
    EXPECT_EQ(medium->range_nm(), (std::array{400.0, 600.0}));
    EXPECT_COMPLEX_NEAR(medium->at(450.0), Complex(1.55, 0.15), 1e-15);
    EXPECT_INPUT_ERROR((void)medium->at(601.0),
                       "mine: wavelength_nm: must be within the data, 400 … 600 nm (got 601)");
    EXPECT_INPUT_ERROR((void)measured_constants({"mine", kN, IndexTable{{0.9, 1.0}, {0.0, 0.0}}}),
                       "mine: DATA: n and k must have wavelengths in common");
}

TEST(MeasuredConstants, AreClearWithoutK)
{
    // Cauchy's formula, number 5: n = 1.5 + 0.01 λ⁻².
    const RangedFormula formula{{5, {1.5, 0.01, -2.0}}, {0.4, 0.7}};
    EXPECT_COMPLEX_NEAR(measured_constants({"mine", formula, {}})->at(500.0), Complex(1.54, 0.0),
                        1e-15);
}

}  // namespace
}  // namespace nacre::spectral
