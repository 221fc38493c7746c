// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/textures/texture.h"

#include <gtest/gtest.h>

#include <limits>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {
namespace {

std::string ftxt_error(std::string_view text)
{
    try {
        (void)read_ftxt(text, "cmf.ftxt");
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Ftxt, SizeThenATexelALine)
{
    const TextTexture content = read_ftxt(
        "# nacre:quantity: spectra\r\n\r\n# no key\n2;1\r\n0.5; -1e-3;3;1\n 0;0;0;0.25\n", "f");
    EXPECT_EQ(content.texture.width, 2);
    EXPECT_EQ(content.texture.height, 1);
    EXPECT_EQ(content.texture.channels, 4);
    EXPECT_EQ(content.texture.texels, (std::vector<float>{0.5F, -1e-3F, 3, 1, 0, 0, 0, 0.25F}));
    EXPECT_EQ(content.comments,
              (std::map<std::string, std::string>{{"nacre:quantity", "spectra"}}));
}

TEST(Ftxt, FloatsComeBackBitByBit)
{
    TextTexture content{{.width = 1, .height = 2, .channels = 4, .texels = {}}, {{"a", "b: c"}}};
    content.texture.texels = {1.0F / 3, 1e-45F, 3.4028235e38F, -0.1F, 16777217.0F, 0, 1, 2e-7F};
    const std::string text = write_ftxt(content);
    EXPECT_EQ(text.substr(0, text.find('\n', 10)), "# a: b: c\n1;2");
    const TextTexture read = read_ftxt(text, "f");
    EXPECT_EQ(read.texture.texels, content.texture.texels);
    EXPECT_EQ(read.comments, content.comments);
}

TEST(Ftxt, FewerChannelsAreFilled)
{
    EXPECT_EQ(write_ftxt({{.width = 1, .height = 1, .channels = 1, .texels = {0.5F}}, {}}),
              "1;1\n0.5;0.5;0.5;1\n");
    EXPECT_EQ(write_ftxt({{.width = 1, .height = 1, .channels = 3, .texels = {1, 2, 3}}, {}}),
              "1;1\n1;2;3;1\n");
    const TextTexture infinite{{1, 1, 1, {std::numeric_limits<float>::infinity()}}, {}};
    EXPECT_THROW((void)write_ftxt(infinite), InputError);
    TextTexture two_lines{{1, 1, 1, {0.0F}}, {}};
    two_lines.comments["a"] = "b\n2;2";
    EXPECT_THROW((void)write_ftxt(two_lines), InputError);
}

TEST(Ftxt, NothingIsLoadedFromABadFile)
{
    EXPECT_EQ(ftxt_error("2;1\n1;2;3;4\n"),
              "cmf.ftxt:2: texel: must be as many as 2 x 1 = 2 (got 1)");
    EXPECT_EQ(ftxt_error("1;1\n1;2;3;4\n1;2;3;4\n"),
              "cmf.ftxt:3: texel: must be as many as 1 x 1 = 1 (got 2)");
    EXPECT_EQ(ftxt_error("1;1\n1;2;3\n"), "cmf.ftxt:2: texel: must be r;g;b;a (got 3 numbers)");
    EXPECT_EQ(ftxt_error("1;1\n1;two;nan;4\n"),
              "cmf.ftxt:2: texel: must be finite numbers (got two)\n"
              "cmf.ftxt:2: texel: must be finite numbers (got nan)");
    EXPECT_EQ(ftxt_error(""), "cmf.ftxt: size: must be width;height (got nothing)");
    for (const char* size : {"0;1", "1.5;1", "1", "1;1;1", "65537;1", "-1;1", "a;b", "1e999;1"})
        EXPECT_NE(ftxt_error(std::string(size) + "\n1;1;1;1\n")
                      .find("1: size: must be width;height, whole numbers in [1, 65536] (got "),
                  std::string::npos)
            << size;
}

TEST(Ftxt, ALargeSizeAsksForNoMemory)
{
    EXPECT_NE(ftxt_error("65536;65536\n1;1;1;1\n").find("4294967296 (got 1)"), std::string::npos);
}

}  // namespace
}  // namespace nacre::spectral
