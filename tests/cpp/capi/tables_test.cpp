// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/tables.h"
#include "refusal.h"

#include <gtest/gtest.h>

namespace {

using nacre::test::error;

TEST(CapiResult, NothingHoldsNothing)
{
    EXPECT_EQ(nacre_result_tables(nullptr), 0U);
    nacre_table table;
    EXPECT_EQ(error(nacre_result_table(nullptr, 0, &table)), "result: must not be null");
    nacre_result_free(nullptr);
}

}  // namespace
