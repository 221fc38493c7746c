// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/dispersion_formula.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::spectral {
namespace {

// Coefficients from the refractiveindex.info database: SiO2 Malitson, N-BK7 SCHOTT, PMMA Beadie,
// TiO2 Devore-o, HfO2 Al-Kuhaili, Ar Bideau-Mehu, Si Edwards, AgBr Schröter, urea Rosker-e.
// Values: the formulas of refractiveindex.info evaluated with 30 digits (mpmath).
TEST(DispersionFormula, MatchesAnIndependentEvaluation)
{
    struct Case {
        int formula;
        std::vector<double> coefficients;
        double nm, n;
    };
    const Case cases[] = {
        {1,
         {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161},
         587.6,
         1.4584623420532409},
        {2,
         {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653},
         587.6,
         1.5167984379050087},
        {3,
         {2.1778, 6.1209e-3, 2, -1.5004e-3, 4, 2.3678e-2, -2, -4.2137e-3, -4, 7.3417e-4, -6,
          -4.5042e-5, -8},
         587.6,
         1.4925258261424658},
        {4, {5.913, 0.2441, 0, 0.0803, 1, 0, 0, 0, 1}, 587.6, 2.6142347434687979},
        {5, {1.875, 6.28e-3, -2, 5.80e-4, -4}, 587.6, 1.8980536675182515},
        {6,
         {0, 2.50141e-3, 91.012, 5.00283e-4, 87.892, 5.22343e-2, 214.02},
         354.05,
         1.0002898975595027},
        {7, {3.41983, 0.159906, -0.123109, 1.26878E-6, -1.95104E-9}, 13718.65, 3.4208459842508224},
        {8, {0.452505, 0.09939, 0.070537, -0.000150}, 587.6, 2.2579318545687375},
        {9, {2.51527, 0.0240, 0.0300, 0.020, 1.52, 0.8771}, 587.6, 1.6064609483362371},
    };
    for (const auto& [formula, coefficients, nm, n] : cases) {
        const DispersionFormula dispersion{formula, coefficients};
        EXPECT_NEAR(dispersion.index_at(nm / 1000.0), n, 1e-15 * n * 4) << "formula " << formula;
        EXPECT_EQ(coefficient_count_problem(formula, coefficients.size()), "");
    }
}

TEST(DispersionFormula, HasNoIndexBetweenPoleAndZero)
{
    EXPECT_TRUE(std::isnan(DispersionFormula{2, {0.0, 1.0, 0.3}}.index_at(0.5)));
}

TEST(DispersionFormula, CountsItsCoefficients)
{
    EXPECT_EQ(coefficient_count_problem(1, 4),
              "formula 1 takes an odd number of coefficients, 3 … 17 (got 4)");
    EXPECT_EQ(coefficient_count_problem(8, 5), "formula 8 takes 4 coefficients (got 5)");
}

}  // namespace
}  // namespace nacre::spectral
