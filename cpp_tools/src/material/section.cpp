// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/limits.h"
#include "toml_keys.h"

namespace nacre::material {
namespace {

std::string_view type_name(const toml::node& node)
{
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "a boolean";
        default:
            return "a date or time";
    }
}

bool is_printable(std::string_view text)
{
    return std::ranges::none_of(text, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
    });
}

}  // namespace

bool Bounds::contains(double value) const noexcept
{
    return std::isfinite(value) && (exclusive_min ? value > min : value >= min) && value <= max;
}

std::string Bounds::text(double value) const
{
    if (!std::isfinite(value)) return "must be a finite number";
    const bool is_share = min == 0.0 && !exclusive_min && max <= 100.0;
    if (is_share) return fmt::format("must be in [{}, {}]", min, max);
    if (value > max) return fmt::format("must be ≤ {}", max);
    return fmt::format("must be {} {}", exclusive_min ? ">" : "≥", min);
}

bool Section::is_table(std::string_view key) const
{
    const toml::node* node = table_->get(key);
    return node && node->is_table();
}

int Section::line() const
{
    return static_cast<int>(table_->source().begin.line);
}

int Section::line(std::string_view key) const
{
    const toml::node* node = table_->get(key);
    return node ? static_cast<int>(node->source().begin.line) : line();
}

std::string Section::field(std::string_view key) const
{
    if (path_.empty()) return std::string(key);
    return key.empty() ? path_ : fmt::format("{}.{}", path_, key);
}

void Section::report(std::string_view key, std::string message)
{
    problems_->add({file_, line(key), field(key), std::move(message)});
}

void Section::report_type(std::string_view key, const toml::node& node, std::string_view wanted)
{
    report(key, fmt::format("must be {} (got {})", wanted, type_name(node)));
}

bool Section::allows(std::string_view key)
{
    known_.emplace(key);
    return has(key);
}

bool Section::require(std::string_view key, std::string_view what)
{
    if (allows(key)) return true;
    report(key, fmt::format("missing; must be {}", what));
    return false;
}

const toml::node* Section::find(std::string_view key)
{
    known_.emplace(key);
    return table_->get(key);
}

std::optional<double> Section::number(std::string_view key, const Bounds& bounds)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_number()) {
        report_type(key, *node, "a number");
        return std::nullopt;
    }
    const double value = *node->value<double>();
    if (!bounds.contains(value)) {
        report(key, fmt::format("{} (got {})", bounds.text(value), value));
        return std::nullopt;
    }
    return value;
}

std::optional<int> Section::integer(std::string_view key, int min, int max)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_integer()) {
        report_type(key, *node, "an integer");
        return std::nullopt;
    }
    const std::int64_t value = *node->value<std::int64_t>();
    if (value < min || value > max) {
        const std::string allowed =
            min == max ? std::to_string(min) : fmt::format("in [{}, {}]", min, max);
        report(key, fmt::format("must be {} (got {})", allowed, value));
        return std::nullopt;
    }
    return static_cast<int>(value);
}

std::optional<std::string> Section::text(std::string_view key)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) {
        report_type(key, *node, "a string");
        return std::nullopt;
    }
    std::string value = *node->value<std::string>();
    if (value.empty() || !is_printable(value)) {
        report(key, "must be one line of text without control characters, not empty");
        return std::nullopt;
    }
    return value;
}

std::optional<bool> Section::boolean(std::string_view key)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) {
        report_type(key, *node, "true or false");
        return std::nullopt;
    }
    return node->value<bool>();
}

std::optional<std::vector<double>> Section::numbers(std::string_view key, std::size_t min_size,
                                                    std::size_t max_size)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    if (!array) {
        report_type(key, *node, "an array of numbers");
        return std::nullopt;
    }
    std::vector<double> values;
    for (const toml::node& item : *array)
        if (item.is_number() && std::isfinite(*item.value<double>()))
            values.push_back(*item.value<double>());
    if (values.size() != array->size() || values.size() < min_size || values.size() > max_size) {
        report(key, fmt::format("must be {} to {} finite numbers", min_size, max_size));
        return std::nullopt;
    }
    return values;
}

std::optional<std::vector<std::string>> Section::texts(std::string_view key)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* array = node->as_array();
    if (!array) {
        report_type(key, *node, "an array of strings");
        return std::nullopt;
    }
    std::vector<std::string> values;
    for (const toml::node& item : *array)
        if (const auto* text = item.as_string(); text && !text->get().empty())
            values.push_back(text->get());
    if (values.size() != array->size()) {
        report(key, "must be strings that are not empty");
        return std::nullopt;
    }
    if (!std::ranges::all_of(values, is_printable)) {
        report(key, "must be lines of text without control characters");
        return std::nullopt;
    }
    return values;
}

std::optional<Section> Section::section(std::string_view key)
{
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::table* table = node->as_table();
    if (!table) {
        report_type(key, *node, "a table");
        return std::nullopt;
    }
    return Section(*table, field(key), file_, *problems_);
}

std::vector<Section> Section::sections(std::string_view key)
{
    const toml::node* node = find(key);
    if (!node) return {};
    const toml::array* array = node->as_array();
    if (!array) {
        report(key, fmt::format("must be an array of tables, written [[{}]] (got {})", key,
                                type_name(*node)));
        return {};
    }
    std::vector<Section> result;
    for (std::size_t i = 0; i < array->size(); ++i) {
        const toml::node& item = (*array)[i];
        const std::string path = fmt::format("{}[{}]", field(key), i);
        if (const toml::table* table = item.as_table())
            result.emplace_back(*table, path, file_, *problems_);
        else
            problems_->add({file_, static_cast<int>(item.source().begin.line), path,
                            fmt::format("must be a table (got {})", type_name(item))});
    }
    return result;
}

void Section::report_unknown_keys()
{
    for (const auto& [key, node] : *table_) {
        if (known_.contains(key.str())) continue;
        problems_->add({file_, static_cast<int>(key.source().begin.line), field(key.str()),
                        fmt::format("unknown key; allowed here: {}", fmt::join(known_, ", "))});
    }
}

void read_toml(std::string_view toml, std::string_view file,
               const std::function<void(Section&)>& read)
{
    if (toml.size() > kMaxTextBytes)
        throw InputError({std::string(file), 0, "",
                          "must not be larger than " + std::to_string(kMaxTextBytes) + " bytes"});
    if (const int line = line_of_endless_key(toml))
        throw InputError({std::string(file), line, "",
                          fmt::format("must not have keys of more than {} parts", kMaxKeyParts)});
    toml::table table;
    try {
        table = toml::parse(toml, file);
    } catch (const toml::parse_error& error) {
        throw InputError(Diagnostic{std::string(file), static_cast<int>(error.source().begin.line),
                                    "", std::string(error.description())});
    }
    DiagnosticList problems;
    Section root(table, "", std::string(file), problems);
    read(root);
    problems.throw_first_if_any();
}

}  // namespace nacre::material
