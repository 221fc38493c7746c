// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/literals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace nacre::oslgen {
namespace {

TEST(Literals, AreAlwaysFloats)
{
    EXPECT_EQ(literal(5.0), "5.0");
    EXPECT_EQ(literal(-0.25), "-0.25");
    EXPECT_EQ(literal(1e-9), "1e-09");
    EXPECT_EQ(literal(std::array<double, 3>{1.0, 0.5, -2.0}), "color(1.0, 0.5, -2.0)");
}

TEST(Literals, ReadBackAsTheSameNumber)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-30.0f, 30.0f);
    for (int i = 0; i < 1000; ++i) {
        const float value = std::pow(10.0f, exponent(random));
        EXPECT_EQ(std::stof(literal(static_cast<double>(value))), value);
    }
}

TEST(Literals, ArraysKeepToTheLineLength)
{
    const std::vector<double> values(100, 360.12345);
    for (const char* line_end : {"", " \\"}) {
        std::istringstream lines(array_literal(values, line_end));
        int count = 0;
        for (std::string line; std::getline(lines, line); ++count) {
            EXPECT_LE(line.size(), 100u);
            EXPECT_TRUE(lines.eof() || line.ends_with(line_end)) << line;
        }
        EXPECT_GT(count, 5);
    }
    EXPECT_EQ(array_literal(std::vector<double>{1.0, 2.0}), "{\n        1.0, 2.0 }");
}

}  // namespace
}  // namespace nacre::oslgen
