// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/optical_constants.h"

#include <cmath>
#include <limits>

#include "support/expect.h"
#include "support/not_numbers.h"

namespace nacre::spectral {
namespace {

using test::kInf;
using test::kNan;

TEST(ConstantIndex, IsTheSameEverywhere)
{
    const auto medium = constant_index({1.5, 0.25});
    EXPECT_EQ(medium->at(360.0), Complex(1.5, 0.25));
    EXPECT_EQ(medium->at(1e6), Complex(1.5, 0.25));
    EXPECT_EQ(medium->range_nm(), (std::array<double, 2>{0.0, kInf}));
    for (const Complex n : medium->on_grid()) EXPECT_EQ(n, Complex(1.5, 0.25));
}

TEST(ConstantIndex, RefusesGainAndWhatIsNoIndex)
{
    EXPECT_INPUT_ERROR((void)constant_index({0.0, 0.0}), "n: must be finite and > 0 (got 0)");
    EXPECT_INPUT_ERROR((void)constant_index({-1.5, 0.0}), "n: must be finite and > 0 (got -1.5)");
    EXPECT_INPUT_ERROR((void)constant_index({1.5, -0.1}), "k: must be finite and ≥ 0 (got -0.1)");
    EXPECT_INPUT_ERROR((void)constant_index({kNan, 0.0}), "n: must be finite");
    EXPECT_INPUT_ERROR((void)constant_index({kInf, 0.0}), "n: must be finite");
    EXPECT_INPUT_ERROR((void)constant_index({1.5, kNan}), "k: must be finite");
    EXPECT_INPUT_ERROR((void)constant_index({1.5, kInf}), "k: must be finite");
}

TEST(Cauchy, FollowsItsFormula)
{
    const auto medium = cauchy(1.5, 0.004, 0.0001, 0.02);
    EXPECT_COMPLEX_NEAR(medium->at(500.0), Complex(1.5 + 0.004 / 0.25 + 0.0001 / 0.0625, 0.02),
                        1e-15);
    EXPECT_INPUT_ERROR((void)cauchy(1.5, kNan), "cauchy[1]: must be finite (got nan)");
    EXPECT_INPUT_ERROR((void)cauchy(1.5, 0.0, 0.0, -1.0), "k: must be finite and ≥ 0 (got -1)");
    EXPECT_INPUT_ERROR((void)cauchy(0.5, -0.2)->at(500.0), "must give an index n > 0 at 500 nm");
}

// SCHOTT data sheet N-BK7 517642.251: n at F, d and C.
TEST(Sellmeier, MatchesTheDataSheetOfNBk7)
{
    const auto glass =
        sellmeier({1.03961212, 0.231792344, 1.01046945}, {0.00600069867, 0.0200179144, 103.560653});
    EXPECT_NEAR(glass->at(486.1327).real(), 1.52238, 5e-6);
    EXPECT_NEAR(glass->at(587.5618).real(), 1.51680, 5e-6);
    EXPECT_NEAR(glass->at(656.2725).real(), 1.51432, 5e-6);
    EXPECT_EQ(glass->at(587.5618).imag(), 0.0);
}

TEST(Sellmeier, RefusesUnequalListsAndPoles)
{
    EXPECT_INPUT_ERROR((void)sellmeier({1.0, 2.0}, {0.01}),
                       "sellmeier: must have as many b as c, 1 … 6 (got 2 and 1)");
    EXPECT_INPUT_ERROR((void)sellmeier({}, {}), "(got 0 and 0)");
    EXPECT_INPUT_ERROR((void)sellmeier(std::vector<double>(7, 0.1), std::vector<double>(7, 0.1)),
                       "(got 7 and 7)");
    EXPECT_INPUT_ERROR((void)sellmeier({1.0}, {kInf}), "sellmeier.c[0]: must be finite");
    EXPECT_INPUT_ERROR((void)sellmeier({1.0}, {0.25})->at(500.0), "at 500 nm (got inf)");
    EXPECT_INPUT_ERROR((void)sellmeier({1.0}, {0.3})->at(500.0), "must give an index n > 0");
}

TEST(Abbe, HasTheIndexAndTheAbbeNumber)
{
    const auto glass = abbe(1.5168, 64.17);
    const double n_f = glass->at(486.1327).real();
    const double n_c = glass->at(656.2725).real();
    EXPECT_NEAR(glass->at(587.5618).real(), 1.5168, 1e-15);
    EXPECT_NEAR((1.5168 - 1.0) / (n_f - n_c), 64.17, 1e-9);
}

TEST(Abbe, RefusesWhatIsNoGlass)
{
    EXPECT_INPUT_ERROR((void)abbe(1.0, 64.0), "abbe.n_d: must be finite and > 1 (got 1)");
    EXPECT_INPUT_ERROR((void)abbe(1.5, 0.0), "abbe.v_d: must be finite and > 0 (got 0)");
    EXPECT_INPUT_ERROR((void)abbe(kNan, kNan), "abbe.v_d: must be finite and > 0 (got nan)");
}

TEST(OpticalConstants, OnTheGridLinearInBetween)
{
    std::array<Complex, kWavelengths> n;
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = {1.5 + 0.001 * static_cast<double>(i), 0.25};
    const auto medium = index_on_grid(n);
    EXPECT_COMPLEX_NEAR(medium->at(360.0), n[0], 0.0);
    EXPECT_COMPLEX_NEAR(medium->at(830.0), n[470], 0.0);
    EXPECT_COMPLEX_NEAR(medium->at(500.25), Complex(1.64025, 0.25), 1e-15);
    EXPECT_INPUT_ERROR((void)medium->at(359.9), "n: must be within 360 … 830 nm (got 359.9)");
    n[3] = {1.5, -0.1};
    EXPECT_INPUT_ERROR((void)index_on_grid(n), "k at 363 nm: must be finite and ≥ 0 (got -0.1)");
}

}  // namespace
}  // namespace nacre::spectral
