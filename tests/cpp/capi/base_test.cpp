// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/base.h"

#include <gtest/gtest.h>

namespace {

TEST(Capi, VersionsAreThoseOfTheHeader)
{
    EXPECT_EQ(nacre_api_version(), NACRE_API_VERSION);
    EXPECT_STREQ(nacre_version(), NACRE_EXPECTED_VERSION);
}

}  // namespace
