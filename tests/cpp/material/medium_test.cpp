// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/medium.h"

#include <gtest/gtest.h>

#include <string>

namespace nacre::material {
namespace {

MediumSpec medium(const std::string& keys)
{
    MediumSpec result;
    read_toml("[base]\n" + keys + "\n", "t.toml",
              [&](Section& root) { result = read_medium_at(root, "base"); });
    return result;
}

TEST(Medium, HasFiveForms)
{
    EXPECT_EQ(std::get<LibraryMedium>(medium("medium = \"air\"").value).key, "air");
    EXPECT_EQ(std::get<ConstantMedium>(medium("n = 1.5\nk = 0.1").value),
              (ConstantMedium{1.5, 0.1}));
    EXPECT_EQ(std::get<CauchyMedium>(medium("cauchy = [1.4, 0.01]").value),
              (CauchyMedium{{1.4, 0.01}, 0.0}));
    EXPECT_EQ(std::get<SellmeierMedium>(medium("sellmeier = { b = [1], c = [0.01] }").value),
              (SellmeierMedium{{1.0}, {0.01}}));
    EXPECT_EQ(std::get<AbbeMedium>(medium("abbe = { n_d = 1.6, v_d = 30 }").value),
              (AbbeMedium{1.6, 30.0}));
}

TEST(Medium, KnowsWhereItWasNamed)
{
    const MediumSpec spec = medium("medium = \"air\"");
    EXPECT_EQ(spec.line, 2);
    EXPECT_EQ(spec.field, "base.medium");
}

TEST(Medium, AbsorbsWhereItSaysSo)
{
    EXPECT_TRUE(medium("n = 1.5\nk = 0.1").absorbs());
    EXPECT_TRUE(medium("cauchy = [1.4]\nk = 0.1").absorbs());
    EXPECT_FALSE(medium("n = 1.5").absorbs());
    EXPECT_FALSE(medium("medium = \"Ag/Johnson\"").absorbs());
}

}  // namespace
}  // namespace nacre::material
