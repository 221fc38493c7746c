// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/template.h"

#include <gtest/gtest.h>

#include "nacre/kinds/kind.h"
#include "nacre/kinds/read_template.h"

namespace nacre::kinds {
namespace {

TEST(MaterialTemplate, CopiesShareWhatTheyAreMadeOf)
{
    const auto source = parse_template(R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
[glass]
n = 1.5
)",
                                       "t.toml");
    MaterialTemplate copy = source;
    copy.roughness = 0.5;
    EXPECT_EQ(copy.kind, source.kind);
    EXPECT_EQ(source.roughness, 0.0);
}

}  // namespace
}  // namespace nacre::kinds
