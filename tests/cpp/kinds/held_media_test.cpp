// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/held_media.h"

#include <gtest/gtest.h>

#include "nacre/kinds/read_template.h"

namespace nacre::kinds {
namespace {

TEST(HeldMedia, NamesEachOnce)
{
    const auto source = parse_template(R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
medium = "BaTiO3/Wemple-o"
thickness_nm = 10
[[layer]]
medium = "BaTiO3/Wemple-o"
thickness_nm = 20
[substrate]
n = 1.5
)",
                                       "t.toml");
    const auto held = held_media(source, {});
    ASSERT_EQ(held.size(), 1u);
    EXPECT_EQ(held[0].medium, "BaTiO3/Wemple-o");
}

}  // namespace
}  // namespace nacre::kinds
