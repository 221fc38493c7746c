// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "glass/index_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace nacre::kinds::glass {
namespace {

double at(const IndexCurve& curve, double nm)
{
    const double x = curve.slope_nm / nm + curve.offset;
    double sum = 0.0;
    for (auto it = curve.power.rbegin(); it != curve.power.rend(); ++it) sum = sum * x + *it;
    return sum;
}

double error(const IndexCurve& curve, const std::function<double(double)>& index)
{
    double largest = 0.0;
    for (int nm = 360; nm <= 830; ++nm)
        largest = std::max(largest, std::abs(at(curve, nm) - index(nm)));
    return largest;
}

double flint(double nm)  // N-SF11, Schott
{
    const double l2 = nm * nm * 1e-6;
    return std::sqrt(1.0 + 1.73759695 * l2 / (l2 - 0.013188707) +
                     0.313747346 * l2 / (l2 - 0.0623068142) + 1.89878101 * l2 / (l2 - 155.23629));
}

TEST(IndexCurve, GoesThroughAFlint)
{
    const IndexCurve curve = index_curve(flint);
    EXPECT_LE(error(curve, flint), 1e-6);
    EXPECT_LE(curve.error, 1e-6);
    EXPECT_LE(curve.power.size(), 11U);
    EXPECT_NEAR(curve.slope_nm / 360.0 + curve.offset, 1.0, 1e-12);
    EXPECT_NEAR(curve.slope_nm / 830.0 + curve.offset, -1.0, 1e-12);
}

TEST(IndexCurve, TakesNoMoreThanItNeeds)
{
    const auto cauchy = [](double nm) { return 1.5 + 4000.0 / (nm * nm); };
    EXPECT_EQ(index_curve(cauchy).power.size(), 3U);
    const IndexCurve even = index_curve([](double) { return 1.333; });
    EXPECT_EQ(even.power.size(), 2U);
    EXPECT_NEAR(at(even, 500.0), 1.333, 1e-15);
}

TEST(IndexCurve, StatesTheErrorOfWhatIsNoGlass)
{
    const auto step = [](double nm) { return nm < 500.0 ? 1.6 : 1.5; };
    const IndexCurve curve = index_curve(step);
    EXPECT_EQ(curve.power.size(), 13U);
    EXPECT_GT(curve.error, 0.01);
    EXPECT_NEAR(error(curve, step), curve.error, 1e-9);
}

}  // namespace
}  // namespace nacre::kinds::glass
