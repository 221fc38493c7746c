// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/text_lines.h"

#include <cmath>
#include <string>

#include "nacre/core/limits.h"
#include "support/expect.h"

namespace nacre {
namespace {

TEST(TextLines, EndInEitherWayAfterAByteOrderMark)
{
    TextLines lines("\xEF\xBB\xBFone\r\ntwo\n\nlast");
    EXPECT_EQ(lines.next(), "one");
    EXPECT_EQ(lines.next(), "two");
    EXPECT_EQ(lines.number(), 2);
    EXPECT_EQ(lines.next(), "");
    EXPECT_EQ(lines.next(), "last");
    EXPECT_EQ(lines.next(), std::nullopt);
}

TEST(TextLines, WordsAndNumbers)
{
    EXPECT_EQ(trimmed(" \ta b\r "), "a b");
    EXPECT_EQ(split_words("1, 2\t3"), (std::vector<std::string_view>{"1", "2", "3"}));
    EXPECT_EQ(parse_number("-1.5e2"), -150.0);
    EXPECT_TRUE(std::isnan(parse_number("nan").value()));
    for (const char* text : {"", "1 ", "1x", "0x10"}) EXPECT_FALSE(parse_number(text)) << text;
    EXPECT_TRUE(same_letters("Kind", "kIND"));
    EXPECT_FALSE(same_letters("Kind", "Kinds"));
}

TEST(TextLines, WhatIsNoTextIsShownAsQuestionMarks)
{
    EXPECT_EQ(clean_text("a\nb\xFF"), "a b?");
    EXPECT_EQ(readable_lines("a\n\x01\xFF"), "a\n??");
    EXPECT_EQ(utf8_of_utf16(std::string_view("\xFF\xFEn\0", 4)), "n");
    EXPECT_EQ(utf8_of_utf16("n"), "");
}

TEST(FileProblems, NameFileAndLine)
{
    FileProblems problems("x.csv");
    EXPECT_TRUE(problems.empty());
    EXPECT_NO_THROW(problems.throw_if_any());
    problems.add(3, "value", "must be a number");
    EXPECT_FALSE(problems.empty());
    EXPECT_INPUT_ERROR(problems.throw_if_any(), "x.csv:3: value: must be a number");
    EXPECT_NO_THROW(check_size("short", "x.csv"));
    EXPECT_INPUT_ERROR(check_size(std::string(kMaxTextBytes + 1, 'x'), "x.csv"), "x.csv");
}

}  // namespace
}  // namespace nacre
