// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/diagnostics.h"

/// @file
/// The sections of a template under read, with every problem kept for the end.

namespace nacre::material {

/// Allowed values of a number. `exclusive_min` turns ≥ into >.
struct Bounds {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool exclusive_min = false;

    [[nodiscard]] bool contains(double value) const noexcept;
    /// What `value` breaks: `must be in [0, 1]` of a share, else `must be > 0`, `must be ≤ 1e8`, …
    [[nodiscard]] std::string text(double value) const;
};

/// A table of the template under read: knows its path, collects problems, and in the end reports
/// the keys that nobody asked for. Readers return nothing where they reported a problem.
class Section {
public:
    Section(const toml::table& table, std::string path, std::string file, DiagnosticList& problems)
        : table_(&table), path_(std::move(path)), file_(std::move(file)), problems_(&problems)
    {}

    [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
    [[nodiscard]] bool is_table(std::string_view key) const;
    [[nodiscard]] int line(std::string_view key) const;  ///< of the value, or of the table
    [[nodiscard]] int line() const;
    [[nodiscard]] std::string field(std::string_view key) const;

    std::optional<double> number(std::string_view key, const Bounds& bounds);
    std::optional<int> integer(std::string_view key, int min, int max);
    std::optional<std::string> text(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    /// Finite numbers, `min_size` to `max_size` of them.
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t min_size,
                                               std::size_t max_size);
    /// Strings that are not empty.
    std::optional<std::vector<std::string>> texts(std::string_view key);
    std::optional<Section> section(std::string_view key);
    /// `[[key]]` or `key = [{…}]`; empty when absent.
    std::vector<Section> sections(std::string_view key);

    /// Makes the key a known one. @return whether it is there
    bool allows(std::string_view key);
    /// Reports `missing` when the key is absent. @return whether it is there
    bool require(std::string_view key, std::string_view what);
    void report(std::string_view key, std::string message);
    void report_unknown_keys();

private:
    const toml::node* find(std::string_view key);
    void report_type(std::string_view key, const toml::node& node, std::string_view wanted);

    const toml::table* table_;
    std::string path_, file_;
    DiagnosticList* problems_;
    std::set<std::string, std::less<>> known_;
};

/// Parses TOML and hands its root to `read`.
/// @param file  what to call the input in messages
/// @throws InputError with every problem that was reported, each with its line
void read_toml(std::string_view toml, std::string_view file,
               const std::function<void(Section&)>& read);

}  // namespace nacre::material
