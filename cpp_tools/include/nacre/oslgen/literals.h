// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Constants as OSL source text.

namespace nacre::oslgen {

/// Shortest text that reads back as the same single-precision number, always a float in OSL.
[[nodiscard]] std::string literal(double value);

/// `color(r, g, b)`
[[nodiscard]] std::string literal(const std::array<double, 3>& colour);

/// `{ a, b, … }`, broken into lines of at most 100 characters. `line_end` goes before each break:
/// a macro wants a backslash there.
[[nodiscard]] std::string array_literal(const std::vector<double>& values,
                                        std::string_view line_end = "");
[[nodiscard]] std::string array_literal(const std::vector<std::array<double, 3>>& colours,
                                        std::string_view line_end = "");

}  // namespace nacre::oslgen
