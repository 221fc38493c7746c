// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/dispersive_stack.h"

#include <gtest/gtest.h>

namespace nacre::optics {
namespace {

TEST(ObliqueLight, IsUnpolarisedUnlessItSaysOtherwise)
{
    EXPECT_EQ(ObliqueLight{.cos_ambient = 1.0}.share_of_s, 0.5);
}

}  // namespace
}  // namespace nacre::optics
