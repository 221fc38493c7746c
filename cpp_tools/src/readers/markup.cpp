// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "markup.h"

#include <algorithm>
#include <array>
#include <utility>

namespace nacre::spectral {

namespace {

/// Length of the tag at the start of `text`; 0 where there is none.
std::size_t tag_length(std::string_view text)
{
    if (text.size() < 3 || text[0] != '<') return 0;
    const char next = text[1];
    const bool is_tag = next == '/' || (next >= 'a' && next <= 'z') || (next >= 'A' && next <= 'Z');
    const std::size_t end = text.find('>');
    return is_tag && end != std::string_view::npos ? end + 1 : 0;
}

/// The character for the entity at the start of `text`, and the entity's length; 0 where none is.
std::pair<std::string_view, std::size_t> entity(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kEntities = {{
        {"&amp;", "&"},
        {"&lt;", "<"},
        {"&gt;", ">"},
        {"&quot;", "\""},
        {"&nbsp;", " "},
        {"&deg;", "°"},
    }};
    for (const auto& [name, character] : kEntities)
        if (text.starts_with(name)) return {character, name.size()};
    return {{}, 0};
}

void trim_end(std::string& text, std::string_view space)
{
    const std::size_t last = text.find_last_not_of(space);
    text.resize(last == std::string::npos ? 0 : last + 1);
}

}  // namespace

std::string plain_text(std::string_view html)
{
    std::string plain;
    while (!html.empty()) {
        if (const std::size_t length = tag_length(html); length > 0) {
            html.remove_prefix(length);
        } else if (const auto [character, size] = entity(html); size > 0) {
            plain += character;
            html.remove_prefix(size);
        } else {
            if (html[0] == '\n') trim_end(plain, " \t\r");
            plain += html[0];
            html.remove_prefix(1);
        }
    }
    trim_end(plain, " \t\r\n");
    plain.erase(0, std::min(plain.find_first_not_of(" \t\r\n"), plain.size()));
    return plain;
}

}  // namespace nacre::spectral
