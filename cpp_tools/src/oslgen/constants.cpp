// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "constants.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "nacre/core/resources.h"

namespace nacre::oslgen {
namespace {

constexpr std::string_view kConstants = "nacre/nacre_constants.h", kView = "nacre/nacre_view.h";
constexpr std::string_view kDefine = "#define ", kPrefix = "NACRE_";

using Values = std::map<std::string_view, std::string_view>;

/// Of lines `#define NAME VALUE`.
Values read_values()
{
    Values values{{"NACRE_TO_VIEWER", "I"}};
    std::string_view text = find_resource("osl/nacre/nacre_constants.h").value();
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (!line.starts_with(kDefine)) continue;
        line.remove_prefix(kDefine.size());
        const std::size_t blank = line.find(' ');
        values.emplace(line.substr(0, blank), line.substr(blank + 1));
    }
    return values;
}

}  // namespace

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_resolved(std::string_view header)
{
    return header == kConstants || header == kView;
}

std::string resolved(std::string_view osl)
{
    static const Values values = read_values();
    std::string result;
    for (std::size_t at = 0; at < osl.size();) {
        const std::size_t found = std::min(osl.find(kPrefix, at), osl.size());
        const auto end = static_cast<std::size_t>(
            std::find_if_not(osl.begin() + static_cast<std::ptrdiff_t>(found), osl.end(), is_word) -
            osl.begin());
        const std::string_view name = osl.substr(found, end - found);
        const bool is_whole = found == 0 || !is_word(osl[found - 1]);
        const auto value = is_whole ? values.find(name) : values.end();
        result += osl.substr(at, found - at);
        result += value == values.end() ? name : value->second;
        at = end;
    }
    return result;
}

}  // namespace nacre::oslgen
