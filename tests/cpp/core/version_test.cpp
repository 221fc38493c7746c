// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/version.h"

#include <gtest/gtest.h>

namespace nacre {
namespace {

TEST(Version, IsTheOneOfTheBuild)
{
    EXPECT_EQ(version(), NACRE_EXPECTED_VERSION);
}

}  // namespace
}  // namespace nacre
