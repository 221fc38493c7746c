// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "nacre/core/diagnostics.h"

/// @file
/// Reading JSON strictly: unknown and doubled keys, wrong types and numbers out of range are errors
/// that name the field and what is allowed.

namespace nacre::tool {

using nlohmann::json;
using nlohmann::ordered_json;

/// A parsed text. `NaN` and `Infinity`, which JSON lacks but Python's json module writes, and 1e999
/// are kept as strings that start with a null character, so that the reader of the field can name
/// them; objects with a key twice are marked for ObjectReader. Either is an error of its record
/// alone.
struct JsonDocument {
    json value;
    std::vector<int> record_lines;  ///< where each element of a top-level array starts, 1-based
};

/// @param file  what to call the input in messages
/// @throws InputError with the line of a syntax error
[[nodiscard]] JsonDocument parse_json(std::string_view text, const std::string& file);

/// The whole of a file, or of the standard input for `-`.
[[nodiscard]] std::string read_input(const std::string& path);

/// What a number may be.
struct Range {
    double min, max;
    bool min_open = false, max_open = false;

    [[nodiscard]] bool contains(double value) const noexcept;
    [[nodiscard]] std::string text() const;  ///< `> 0`, `≥ 0`, `in [0, 90)`
};

extern const Range kAnyNumber, kPositive, kNotNegative;

/// Reads the members of one object. Problems are collected in `problems`; a member that has one
/// reads as nothing.
class ObjectReader {
public:
    /// @param path  prefix of the fields in messages, e.g. `profile`; empty at the top
    ObjectReader(const json& object, std::string path, DiagnosticList& problems);

    [[nodiscard]] bool has(const char* key) const;
    /// A member that must be there; a problem is added when it is not.
    const json* required(const char* key);
    /// A member that may be missing.
    const json* optional(const char* key);

    std::optional<double> number(const char* key, const Range& range);
    /// `fallback` where the member is missing.
    std::optional<double> number_or(const char* key, const Range& range, double fallback);
    std::optional<std::vector<double>> numbers(const char* key, const Range& range);
    std::optional<std::string> text(const char* key);
    /// @param allowed  in the order in which the message lists them
    std::optional<std::string> choice(const char* key, std::vector<std::string_view> allowed);
    /// `fallback` where the member is missing.
    std::optional<std::string> choice_or(const char* key, std::vector<std::string_view> allowed,
                                         const char* fallback);

    /// Every key that was not asked for is a problem; the message lists those that exist.
    void refuse_unknown_keys();

    void problem(std::string_view field, std::string message);
    [[nodiscard]] std::string field(std::string_view key) const;

private:
    const json& object_;
    std::string path_;
    DiagnosticList& problems_;
    std::vector<std::string> known_;
};

/// One number with its range; `field` is the full name in messages.
std::optional<double> read_number(const json& value, const std::string& field, const Range& range,
                                  DiagnosticList& problems);

/// A value as messages quote it: short, on one line.
[[nodiscard]] std::string quoted(const json& value);

}  // namespace nacre::tool
