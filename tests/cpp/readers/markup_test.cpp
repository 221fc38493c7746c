// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "markup.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

TEST(PlainText, LosesTagsAndKeepsWords)
{
    EXPECT_EQ(plain_text("<a href=\"https://doi.org/x\"><i>Appl. Opt.</i> <b>46</b>, 3811</a>\n"),
              "Appl. Opt. 46, 3811");
    EXPECT_EQ(plain_text("TiO<sub>2</sub><br>\nfilm<BR/>"), "TiO2\nfilm");
    EXPECT_EQ(plain_text("Smith &amp; Jones &lt;1 &micro;m"), "Smith & Jones <1 &micro;m");
}

TEST(PlainText, KeepsWhatIsNoTag)
{
    EXPECT_EQ(plain_text("n < 2, k > 1"), "n < 2, k > 1");
    EXPECT_EQ(plain_text("a <b"), "a <b");
    EXPECT_EQ(plain_text("<"), "<");
    EXPECT_EQ(plain_text(""), "");
    EXPECT_EQ(plain_text(" \n\t "), "");
}

}  // namespace
}  // namespace nacre::spectral
