// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/observer.h"

#include <numeric>

#include "nacre/spectral/wavelengths.h"
#include "spectral/grid.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

// ISO/CIE 11664-1:2019, table 1.
TEST(Observer, HoldsTheTableOf1931)
{
    const Observer& cmf = observer(ObserverId::cie1931);
    EXPECT_EQ(cmf.x[at_nm(360)], 0.0001299);
    EXPECT_EQ(cmf.y[at_nm(555)], 1.0);
    EXPECT_EQ(cmf.x[at_nm(600)], 1.0622);
    EXPECT_EQ(cmf.y[at_nm(600)], 0.631);
    EXPECT_EQ(cmf.z[at_nm(450)], 1.77211);
    EXPECT_EQ(cmf.z[at_nm(830)], 0.0);
}

// ISO/CIE 11664-1:2019, table 2.
TEST(Observer, HoldsTheTableOf1964)
{
    const Observer& cmf = observer(ObserverId::cie1964);
    EXPECT_EQ(cmf.x[at_nm(450)], 0.370702);
    EXPECT_EQ(cmf.y[at_nm(550)], 0.991761);
    EXPECT_EQ(cmf.z[at_nm(450)], 1.99480);
}

// CIE 018:2019 quotes the sums, from which the normalisation follows.
TEST(Observer, SumsAreThePublishedOnes)
{
    const auto sum = [](const Sampled& values) {
        return std::accumulate(values.begin(), values.end(), 0.0);
    };
    const Observer& cie1931 = observer(ObserverId::cie1931);
    EXPECT_NEAR(sum(cie1931.x), 106.865469, 1e-6);
    EXPECT_NEAR(cie1931.sum_y, 106.856917, 1e-6);
    EXPECT_NEAR(sum(cie1931.z), 106.892251, 1e-6);
    const Observer& cie1964 = observer(ObserverId::cie1964);
    EXPECT_NEAR(sum(cie1964.x), 116.648519, 1e-6);
    EXPECT_NEAR(cie1964.sum_y, 116.661877, 1e-6);
    EXPECT_NEAR(sum(cie1964.z), 116.673980, 1e-6);
}

TEST(Observer, NamesGoBothWays)
{
    EXPECT_EQ(observer_from_name("cie1931"), ObserverId::cie1931);
    EXPECT_EQ(observer_from_name("cie1964"), ObserverId::cie1964);
    EXPECT_EQ(observer_name(ObserverId::cie1964), "cie1964");
    EXPECT_INPUT_ERROR((void)observer_from_name("CIE1931"),
                       "observer: must be cie1931 or cie1964 (got 'CIE1931')");
}

}  // namespace
}  // namespace nacre::spectral
