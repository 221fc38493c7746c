// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace nacre::material {
namespace {

void check_range(Section& table, std::optional<double> value, const Quantity& quantity)
{
    if (quantity.min && quantity.max && *quantity.min >= *quantity.max) {
        table.report(
            "min", fmt::format("must be below max (got {} and {})", *quantity.min, *quantity.max));
        return;
    }
    const bool outside = value && ((quantity.min && *value < *quantity.min) ||
                                   (quantity.max && *value > *quantity.max));
    if (outside) table.report("default", fmt::format("must be inside [min, max] (got {})", *value));
}

/// A table { default, min, max, varies }; of a slider min and max must be there.
Quantity read_range(Section& table, const FieldInfo& info)
{
    Quantity result;
    result.line = table.line();
    table.require("default", "a number");
    const auto value = table.number("default", info.bounds);
    bool slider = info.slider == Slider::always;
    if (!slider) slider = result.varies = table.boolean("varies").value_or(false);
    if (slider) {
        table.require("min", "a number, since the value is a slider");
        table.require("max", "a number, since the value is a slider");
    }
    result.min = table.number("min", info.bounds);
    result.max = table.number("max", info.bounds);
    check_range(table, value, result);
    table.report_unknown_keys();
    result.value = value.value_or(0.0);
    return result;
}

std::string wanted_number(const FieldInfo& info)
{
    const Bounds& bounds = info.bounds;
    if (!std::isfinite(bounds.min)) return "a number";
    return fmt::format("a number {} {}", bounds.exclusive_min ? ">" : "≥", bounds.min);
}

void require(Section& section, const FieldInfo& info)
{
    if (info.required) section.require(info.key, wanted(info));
}

}  // namespace

std::string wanted(const FieldInfo& info)
{
    switch (info.type) {
        case FieldType::number:
            return wanted_number(info);
        case FieldType::integer:
            return fmt::format("an integer in [{}, {}]", info.bounds.min, info.bounds.max);
        case FieldType::boolean:
            return "true or false";
        case FieldType::text:
            return "a string";
        case FieldType::texts:
            return "an array of strings";
        case FieldType::choice:
            return fmt::format("one of {}", fmt::join(info.choices, ", "));
        case FieldType::colour:
            return "three numbers";
        case FieldType::quantity:
            return wanted_number(info) + (info.slider == Slider::may
                                              ? ", or { default, min, max, varies }"
                                              : ", or { default, min, max }");
        case FieldType::range:
            return "a table { default, min, max }";
        case FieldType::medium:
            return "a table that names a medium";
    }
    return "";
}

void read_value(Section& section, const FieldInfo& info, double& value)
{
    require(section, info);
    if (const auto number = section.number(info.key, info.bounds)) value = *number;
}

void read_value(Section& section, const FieldInfo& info, std::optional<double>& value)
{
    require(section, info);
    value = section.number(info.key, info.bounds);
}

void read_value(Section& section, const FieldInfo& info, int& value)
{
    require(section, info);
    const auto number = section.integer(info.key, static_cast<int>(info.bounds.min),
                                        static_cast<int>(info.bounds.max));
    if (number) value = *number;
}

void read_value(Section& section, const FieldInfo& info, bool& value)
{
    require(section, info);
    if (const auto truth = section.boolean(info.key)) value = *truth;
}

void read_value(Section& section, const FieldInfo& info, std::string& value)
{
    require(section, info);
    if (auto text = section.text(info.key)) value = std::move(*text);
}

void read_value(Section& section, const FieldInfo& info, std::vector<std::string>& value)
{
    require(section, info);
    if (auto texts = section.texts(info.key)) value = std::move(*texts);
}

void read_value(Section& section, const FieldInfo& info,
                std::optional<std::array<double, 3>>& value)
{
    require(section, info);
    const auto numbers = section.numbers(info.key, 3, 3);
    if (!numbers) return;
    value.emplace();
    std::ranges::copy(*numbers, value->begin());
    for (const double channel : *value) {
        if (info.bounds.contains(channel)) continue;
        section.report(info.key, fmt::format("{} (got {})", info.bounds.text(channel), channel));
        break;
    }
}

void read_value(Section& section, const FieldInfo& info, Quantity& value)
{
    require(section, info);
    if (section.is_table(info.key)) {
        Section table = *section.section(info.key);
        value = read_range(table, info);
        return;
    }
    value.line = section.line(info.key);
    value.value = section.number(info.key, info.bounds).value_or(0.0);
}

void read_value(Section& section, const FieldInfo& info, std::optional<Quantity>& value)
{
    require(section, info);
    if (auto table = section.section(info.key)) value = read_range(*table, info);
}

void read_value(Section& section, const FieldInfo& info, MediumSpec& value)
{
    value = read_medium_at(section, info.key);
    if (info.is_clear && value.absorbs()) section.report(info.key, "must not absorb: k must be 0");
}

std::optional<std::size_t> read_choice(Section& section, const FieldInfo& info)
{
    require(section, info);
    const auto name = section.text(info.key);
    if (!name) return std::nullopt;
    const auto it = std::ranges::find(info.choices, *name);
    if (it != info.choices.end()) return static_cast<std::size_t>(it - info.choices.begin());
    section.report(info.key, fmt::format("must be one of {} (got \"{}\")",
                                         fmt::join(info.choices, ", "), *name));
    return std::nullopt;
}

}  // namespace nacre::material
