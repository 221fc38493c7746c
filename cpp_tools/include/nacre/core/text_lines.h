// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/diagnostics.h"

/// @file
/// What the readers of text files share.

namespace nacre {

/// The lines of a text one after the other: ends of \n or \r\n, a byte order mark passed over.
class TextLines {
public:
    explicit TextLines(std::string_view text);

    /// Nothing after the last one.
    [[nodiscard]] std::optional<std::string_view> next();
    /// Of the line that next() gave last; 1-based.
    [[nodiscard]] int number() const noexcept { return number_; }

private:
    std::string_view rest_;
    int number_ = 0;
};

/// Without spaces, tabs and carriage returns at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text) noexcept;

/// The whole of `text` as one number, which may be infinite or no number; nothing for anything
/// else.
[[nodiscard]] std::optional<double> parse_number(std::string_view text) noexcept;

/// Equal but for the case of ASCII letters.
[[nodiscard]] bool same_letters(std::string_view a, std::string_view b) noexcept;

/// Words between spaces, tabs and commas.
[[nodiscard]] std::vector<std::string_view> split_words(std::string_view text);

/// The start of what a user wrote, for a message: control characters and bytes that are no UTF-8
/// become `?`.
[[nodiscard]] std::string excerpt(std::string_view text);

/// The same on one line and in UTF-8: control characters become spaces, other bytes `?`.
[[nodiscard]] std::string clean_text(std::string_view text);

/// The whole in UTF-8, tabs and line ends as they are: other control characters and bytes that are
/// no UTF-8 become `?`.
[[nodiscard]] std::string readable_lines(std::string_view text);

/// UTF-8 of a text in UTF-16, by its byte order mark or a zero in its first two bytes; empty for
/// any other text. What is no character becomes U+FFFD.
[[nodiscard]] std::string utf8_of_utf16(std::string_view text);

/// What is wrong with one file; after kMaxProblems only that there is more.
class FileProblems {
public:
    explicit FileProblems(std::string file) : file_(std::move(file)) {}

    void add(int line, std::string field, std::string message);
    [[nodiscard]] bool empty() const noexcept { return problems_.empty(); }
    /// @throws InputError when anything was added.
    void throw_if_any() { problems_.throw_if_any(); }

private:
    std::string file_;
    DiagnosticList problems_;
    int count_ = 0;
};

/// @throws InputError for a text above kMaxTextBytes.
void check_size(std::string_view text, const std::string& file);

}  // namespace nacre
