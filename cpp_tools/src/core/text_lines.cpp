// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

#include "nacre/core/limits.h"

namespace nacre {

namespace {

/// Bytes of the UTF-8 character at the start of `text`; 0 where there is none (RFC 3629, table of
/// section 4).
std::size_t utf8_length(std::string_view text)
{
    const auto byte = [text](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto within = [](unsigned value, unsigned low, unsigned high) {
        return value >= low && value <= high;
    };
    const auto tail = [&](std::size_t i) { return within(byte(i), 0x80, 0xBF); };
    const unsigned first = byte(0);
    if (first < 0x80) return 1;
    if (within(first, 0xC2, 0xDF)) return tail(1) ? 2 : 0;
    if (within(first, 0xE0, 0xEF)) {
        const unsigned low = first == 0xE0 ? 0xA0 : 0x80, high = first == 0xED ? 0x9F : 0xBF;
        return within(byte(1), low, high) && tail(2) ? 3 : 0;
    }
    if (within(first, 0xF0, 0xF4)) {
        const unsigned low = first == 0xF0 ? 0x90 : 0x80, high = first == 0xF4 ? 0x8F : 0xBF;
        return within(byte(1), low, high) && tail(2) && tail(3) ? 4 : 0;
    }
    return 0;
}

/// C0, DEL and C1, which steer terminals.
bool is_control(std::string_view character)
{
    const auto first = static_cast<unsigned char>(character.front());
    if (first < 0x20 || first == 0x7F) return true;
    return character.size() == 2 && first == 0xC2 &&
           static_cast<unsigned char>(character[1]) < 0xA0;
}

}  // namespace

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

bool same_letters(std::string_view a, std::string_view b) noexcept
{
    const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; };
    return std::ranges::equal(a, b, {}, upper, upper);
}

std::vector<std::string_view> split_words(std::string_view text)
{
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; };
    std::vector<std::string_view> words;
    for (auto at = text.begin();;) {
        const auto start = std::find_if_not(at, text.end(), is_space);
        if (start == text.end()) return words;
        at = std::find_if(start, text.end(), is_space);
        words.emplace_back(start, at);
    }
}

std::string excerpt(std::string_view text)
{
    constexpr std::size_t kMost = 60;
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        const bool printable = length > 0 && !is_control(character);
        shown += printable ? character : "?";
        text.remove_prefix(character.size());
        if (shown.size() >= kMost) break;
    }
    return text.empty() ? shown : shown + "…";
}

std::string clean_text(std::string_view text)
{
    std::string clean;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0)
            clean += '?';
        else if (is_control(text.substr(0, length)))
            clean += ' ';
        else
            clean += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return std::string(trimmed(clean));
}

namespace {

void append_utf8(std::string& text, std::uint32_t c)
{
    const auto tail = [&](int shift) { text += static_cast<char>(0x80U | ((c >> shift) & 0x3FU)); };
    if (c < 0x80U) {
        text += static_cast<char>(c);
    } else if (c < 0x800U) {
        text += static_cast<char>(0xC0U | (c >> 6U));
        tail(0);
    } else if (c < 0x10000U) {
        text += static_cast<char>(0xE0U | (c >> 12U));
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xF0U | (c >> 18U));
        tail(12);
        tail(6);
        tail(0);
    }
}

}  // namespace

std::string readable_lines(std::string_view text)
{
    const auto is_plain = [](char c) { return (c >= ' ' && c < '\x7F') || c == '\n'; };
    std::string readable;
    readable.reserve(text.size());
    for (;;) {
        const auto plain =
            static_cast<std::size_t>(std::ranges::find_if_not(text, is_plain) - text.begin());
        readable += text.substr(0, plain);
        text.remove_prefix(plain);
        if (text.empty()) break;
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        const bool spacing = character == "\t" || character == "\n" || character == "\r";
        readable += length > 0 && (spacing || !is_control(character)) ? character : "?";
        text.remove_prefix(character.size());
    }
    return readable;
}

std::string utf8_of_utf16(std::string_view text)
{
    const auto byte = [text](std::size_t i) -> std::uint32_t {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    if (text.size() < 2) return {};
    const bool marked =
        (byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF);
    if (!marked && (byte(0) == 0) == (byte(1) == 0)) return {};
    const std::size_t high = marked ? (byte(0) == 0xFE ? 0 : 1) : (byte(0) == 0 ? 0 : 1);
    const auto unit = [&](std::size_t i) { return (byte(i + high) << 8U) | byte(i + 1 - high); };
    std::string decoded;
    for (std::size_t i = marked ? 2 : 0; i < text.size(); i += 2) {
        std::uint32_t c = unit(i);
        const bool first = c >= 0xD800 && c < 0xDC00;
        const std::uint32_t second = first && i + 2 < text.size() ? unit(i + 2) : 0U;
        if (first && second >= 0xDC00 && second < 0xE000) {  // RFC 2781, 2.2
            c = 0x10000U + ((c - 0xD800U) << 10U) + (second - 0xDC00U);
            i += 2;
        } else if (c >= 0xD800 && c < 0xE000) {
            c = 0xFFFD;
        }
        append_utf8(decoded, c);
    }
    return decoded;
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

}  // namespace nacre
