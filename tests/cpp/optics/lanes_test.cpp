// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/lanes.h"

#include <gtest/gtest.h>

namespace nacre::optics {
namespace {

// Vectors of any instruction set are loaded from lanes as they lie.
TEST(Lanes, LieInWholeCacheLines)
{
    EXPECT_EQ(alignof(Lanes), 64u);
    EXPECT_EQ(sizeof(Lanes), kLanes * sizeof(double));
    EXPECT_EQ(sizeof(SingleLanes), kLanes * sizeof(float));
    EXPECT_EQ(sizeof(ComplexLanes), 2 * sizeof(Lanes));
}

}  // namespace
}  // namespace nacre::optics
