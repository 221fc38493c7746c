// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "nacre/capi/base.h"

namespace nacre::test {

/// The message of a call that is refused.
inline std::string error(nacre_status status)
{
    EXPECT_EQ(status, NACRE_INPUT);
    return nacre_last_error();
}

}  // namespace nacre::test
