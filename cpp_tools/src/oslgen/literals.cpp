// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/literals.h"

#include <fmt/format.h>

namespace nacre::oslgen {
namespace {

constexpr std::size_t kLineLength = 98;
constexpr std::string_view kIndent = "        ";

template <class Values>
std::string broken_into_lines(const Values& values, std::string_view line_end)
{
    std::string result = "{";
    std::size_t column = kLineLength;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string item = literal(values[i]) + (i + 1 < values.size() ? "," : " }");
        if (column + item.size() + 1 > kLineLength) {
            result += fmt::format("{}\n{}{}", line_end, kIndent, item);
            column = kIndent.size() + item.size() + line_end.size();
        } else {
            result += ' ' + item;
            column += 1 + item.size();
        }
    }
    return result;
}

}  // namespace

std::string literal(double value)
{
    std::string text = fmt::format("{}", static_cast<float>(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string literal(const std::array<double, 3>& colour)
{
    return fmt::format("color({}, {}, {})", literal(colour[0]), literal(colour[1]),
                       literal(colour[2]));
}

std::string array_literal(const std::vector<double>& values, std::string_view line_end)
{
    return broken_into_lines(values, line_end);
}

std::string array_literal(const std::vector<std::array<double, 3>>& colours,
                          std::string_view line_end)
{
    return broken_into_lines(colours, line_end);
}

}  // namespace nacre::oslgen
