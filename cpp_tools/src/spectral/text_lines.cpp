// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "nacre/core/limits.h"

namespace nacre::spectral {

TextLines::TextLines(std::string_view text) : rest_(text)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

std::optional<std::string_view> TextLines::next()
{
    if (rest_.empty()) return std::nullopt;
    const std::size_t end = rest_.find('\n');
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return line;
}

std::string_view trimmed(std::string_view text) noexcept
{
    constexpr std::string_view kSpace = " \t\r";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::optional<double> parse_number(std::string_view text) noexcept
{
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || end != last) return std::nullopt;
    return number;
}

std::vector<std::string_view> split_words(std::string_view text)
{
    constexpr std::string_view kSpace = " \t\r,";
    std::vector<std::string_view> words;
    for (;;) {
        const std::size_t start = text.find_first_not_of(kSpace);
        if (start == std::string_view::npos) return words;
        text.remove_prefix(start);
        const std::size_t length = std::min(text.find_first_of(kSpace), text.size());
        words.push_back(text.substr(0, length));
        text.remove_prefix(length);
    }
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string shown(text.substr(0, kMost));
    std::ranges::replace_if(
        shown, [](char c) { return c < ' ' || c > '~'; }, '?');
    return text.size() > kMost ? shown + "…" : shown;
}

void FileProblems::add(int line, std::string field, std::string message)
{
    if (++count_ == kMaxProblems) message += "; there is more that is wrong";
    if (count_ <= kMaxProblems) problems_.add({file_, line, std::move(field), std::move(message)});
}

void check_size(std::string_view text, const std::string& file)
{
    if (text.size() > kMaxTextBytes)
        throw InputError(
            {.file = file,
             .field = {},
             .message = fmt::format("must not be larger than {} bytes", kMaxTextBytes)});
}

}  // namespace nacre::spectral
