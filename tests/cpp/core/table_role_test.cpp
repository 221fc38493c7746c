// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/table_role.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace nacre {
namespace {

TEST(TableRole, HasTheNameThatFilesHave)
{
    EXPECT_EQ(table_name({TableOf::R}), "R");
    EXPECT_EQ(table_name({TableOf::T, TableContent::rough}), "T_rough");
    EXPECT_EQ(table_name({TableOf::R, TableContent::further, true}), "R_further_bare");
    EXPECT_EQ(table_name({TableOf::R, TableContent::powers}), "R_schlick");
    EXPECT_EQ(table_name({TableOf::R_inner, TableContent::smooth, true}), "R_inner_bare");
    EXPECT_EQ(table_name({TableOf::lobe_T, TableContent::rough}), "lobe_T_rough");
}

TEST(TableRole, IsFoundByItsName)
{
    std::set<std::string> names;
    for (const TableOf of : {TableOf::R, TableOf::T, TableOf::R_inner, TableOf::T_inner,
                             TableOf::lobe_R, TableOf::lobe_T})
        for (const TableContent content : {TableContent::smooth, TableContent::rough,
                                           TableContent::further, TableContent::powers})
            for (const bool is_bare : {false, true}) {
                const TableRole role{of, content, is_bare};
                EXPECT_TRUE(names.insert(table_name(role)).second) << table_name(role);
                EXPECT_EQ(table_role(table_name(role)), role);
            }
    for (const char* wrong : {"", "r", "R_bare_rough", "R_", "RR"})
        EXPECT_FALSE(table_role(wrong).has_value()) << wrong;
}

TEST(TableRole, IsSpokenOf)
{
    EXPECT_EQ(table_of_name(TableOf::T_inner), "T_inner");
    EXPECT_EQ(table_content_name(TableContent::smooth), "smooth");
    EXPECT_EQ(table_content_name(TableContent::rough), "rough");
    EXPECT_EQ(table_content_name(TableContent::further), "further");
    EXPECT_EQ(table_content_name(TableContent::powers), "powers");
}

}  // namespace
}  // namespace nacre
