// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_slices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::lut {
namespace {

TEST(RoughSlices, SharesRunFromSliceToSlice)
{
    EXPECT_EQ(slice_share(3.0, 3), 0.0);
    EXPECT_EQ(slice_share(10.0, 9), 1.0);
    // alpha = roughness²: half of alpha² lies at 2^(-1/4) of the first slice's roughness.
    EXPECT_NEAR(slice_share(std::pow(0.5, 0.25), 0), 0.5, 1e-15);
}

}  // namespace
}  // namespace nacre::lut
