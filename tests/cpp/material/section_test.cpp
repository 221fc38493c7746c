// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/section.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/expect.h"

namespace nacre::material {
namespace {

std::string problems(const std::string& toml, const std::function<void(Section&)>& read)
{
    return test::input_error_of([&] { read_toml(toml, "t.toml", read); });
}

TEST(Bounds, SayWhatAValueBreaks)
{
    EXPECT_TRUE((Bounds{0.0, 1.0}.contains(1.0)));
    EXPECT_FALSE((Bounds{.min = 0.0, .exclusive_min = true}.contains(0.0)));
    EXPECT_EQ((Bounds{0.0, 1.0}.text(2.0)), "must be in [0, 1]");
    EXPECT_EQ((Bounds{.min = 0.0, .exclusive_min = true}.text(-1.0)), "must be > 0");
    EXPECT_EQ((Bounds{100.0, 1e6}.text(1e7)), "must be ≤ 1000000");
}

TEST(Section, ReadsWhatIsThere)
{
    double number = 0.0;
    std::vector<std::string> paths;
    read_toml("a = 1.5\n[[b]]\nc = true\n[[b]]\n", "t.toml", [&](Section& root) {
        number = root.number("a", {}).value();
        for (Section& each : root.sections("b")) {
            EXPECT_EQ(each.boolean("c").has_value(), paths.empty());
            paths.push_back(each.field("c"));
        }
        EXPECT_FALSE(root.allows("d"));
        root.report_unknown_keys();
    });
    EXPECT_DOUBLE_EQ(number, 1.5);
    EXPECT_EQ(paths, (std::vector<std::string>{"b[0].c", "b[1].c"}));
}

TEST(Section, ReportsAllThatIsWrongWithLineAndField)
{
    const auto read = [](Section& root) {
        static_cast<void>(root.integer("whole", 1, 9));
        root.require("there", "a number");
        root.report_unknown_keys();
    };
    EXPECT_EQ(problems("whole = 10\nmore = 1\n", read),
              "t.toml:1: whole: must be in [1, 9] (got 10)\n"
              "t.toml:1: there: missing; must be a number\n"
              "t.toml:2: more: unknown key; allowed here: there, whole");
}

}  // namespace
}  // namespace nacre::material
