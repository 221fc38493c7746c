// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/diagnostics.h"

#include "nacre/core/limits.h"

#include "support/expect.h"

namespace nacre {
namespace {

TEST(Diagnostic, NamesFileLineFieldAndMessage)
{
    const Diagnostic diagnostic{.file = "soap_film.toml",
                                .line = 12,
                                .field = "layer[0].thickness_nm",
                                .message = "must be ≥ 0 (got -5)"};
    EXPECT_EQ(diagnostic.text(), "soap_film.toml:12: layer[0].thickness_nm: must be ≥ 0 (got -5)");
}

TEST(Diagnostic, LeavesOutWhatIsEmpty)
{
    EXPECT_EQ((Diagnostic{"a.yml", 0, "", "is empty"}).text(), "a.yml: is empty");
    EXPECT_EQ((Diagnostic{"a.yml", 3, "", "is empty"}).text(), "a.yml:3: is empty");
    EXPECT_EQ((Diagnostic{"", 3, "n", "must be > 0"}).text(), "line 3: n: must be > 0");
    EXPECT_EQ((Diagnostic{"", 0, "", "is empty"}).text(), "is empty");
}

TEST(InputError, ListsAllProblemsOneALine)
{
    DiagnosticList list;
    list.throw_if_any();  // nothing yet
    EXPECT_TRUE(list.empty());
    list.add({"a.toml", 1, "x", "first"});
    list.add({"a.toml", 2, "y", "second"});
    EXPECT_FALSE(list.empty());

    try {
        list.throw_if_any();
        FAIL() << "threw nothing";
    } catch (const InputError& error) {
        ASSERT_EQ(error.diagnostics().size(), 2u);
        EXPECT_EQ(error.diagnostics()[1].line, 2);
        EXPECT_STREQ(error.what(), "a.toml:1: x: first\na.toml:2: y: second");
    }
}

TEST(InputError, TellsTheFirstProblemsOfAFile)
{
    DiagnosticList list;
    list.throw_first_if_any();  // nothing yet
    for (int i = 1; i <= kMaxProblems + 1; ++i) list.add({"a.toml", i, "x", "is wrong"});
    try {
        list.throw_first_if_any();
        FAIL() << "threw nothing";
    } catch (const InputError& error) {
        ASSERT_EQ(error.diagnostics().size(), static_cast<std::size_t>(kMaxProblems));
        EXPECT_EQ(error.diagnostics().front().message, "is wrong");
        EXPECT_EQ(error.diagnostics().back().message, "is wrong; there is more that is wrong");
    }
}

}  // namespace
}  // namespace nacre
