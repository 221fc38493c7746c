// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "nacre/material/medium.h"
#include "nacre/material/section.h"

/// @file
/// Keys of a template's sections, each declared once: what reads them, the JSON schema, the sliders
/// and the page of docs follow from that.

namespace nacre::material {

/// A number that may be the artist's to change.
struct Quantity {
    double value = 0.0;  ///< the default
    std::optional<double> min{}, max{};
    bool varies = false;  ///< becomes a socket and an axis of the table
    int line = 0;
};

enum class FieldType {
    number,
    integer,
    boolean,
    text,
    texts,
    choice,    ///< of names, in the order of an enumeration
    colour,    ///< three numbers
    quantity,  ///< a number, or a table { default, min, max }
    range,     ///< such a table
    medium,    ///< a table that names one
};

/// Whether a quantity is the artist's to change.
enum class Slider {
    never,
    may,  ///< where the template says `varies`
    always,
};

/// What there is to know of a key without its value.
struct FieldInfo {
    std::string_view key;
    std::string_view label{};  ///< of the slider that it becomes, without the unit
    std::string_view help{};
    std::string_view unit = "1";
    Bounds bounds{};
    bool required = false;
    bool is_clear = false;  ///< of media: k must be 0
    Slider slider = Slider::never;
    std::span<const std::string_view> choices{};
    FieldType type = FieldType::number;  ///< follows from the member; see field()
};

/// What the message of a missing key asks for: `a number ≥ 0`, …
[[nodiscard]] std::string wanted(const FieldInfo& info);

/// The key's entry in the JSON schema.
[[nodiscard]] nlohmann::ordered_json field_schema(const FieldInfo& info);

/// Read what is there; report what is wrong, or missing and required; leave the value be otherwise.
void read_value(Section& section, const FieldInfo& info, double& value);
void read_value(Section& section, const FieldInfo& info, std::optional<double>& value);
void read_value(Section& section, const FieldInfo& info, int& value);
void read_value(Section& section, const FieldInfo& info, bool& value);
void read_value(Section& section, const FieldInfo& info, std::string& value);
void read_value(Section& section, const FieldInfo& info, std::vector<std::string>& value);
void read_value(Section& section, const FieldInfo& info,
                std::optional<std::array<double, 3>>& value);
void read_value(Section& section, const FieldInfo& info, Quantity& value);
void read_value(Section& section, const FieldInfo& info, std::optional<Quantity>& value);
void read_value(Section& section, const FieldInfo& info, MediumSpec& value);

/// Index of the name that is there, or nothing.
[[nodiscard]] std::optional<std::size_t> read_choice(Section& section, const FieldInfo& info);

template <class Enum>
requires std::is_enum_v<Enum>
void read_value(Section& section, const FieldInfo& info, Enum& value)
{
    if (const auto choice = read_choice(section, info)) value = static_cast<Enum>(*choice);
}

template <class Value>
constexpr FieldType field_type()
{
    using std::is_same_v;
    if constexpr (std::is_enum_v<Value>) return FieldType::choice;
    if constexpr (is_same_v<Value, int>) return FieldType::integer;
    if constexpr (is_same_v<Value, bool>) return FieldType::boolean;
    if constexpr (is_same_v<Value, std::string>) return FieldType::text;
    if constexpr (is_same_v<Value, std::vector<std::string>>) return FieldType::texts;
    if constexpr (is_same_v<Value, std::optional<std::array<double, 3>>>) return FieldType::colour;
    if constexpr (is_same_v<Value, Quantity>) return FieldType::quantity;
    if constexpr (is_same_v<Value, std::optional<Quantity>>) return FieldType::range;
    if constexpr (is_same_v<Value, MediumSpec>) return FieldType::medium;
    return FieldType::number;
}

/// A key and the member of `Spec` that has its value.
template <class Spec>
struct Field {
    FieldInfo info;
    void (*read)(Section&, const FieldInfo&, Spec&);
    /// Whether the key is known beside what was read before it; none: always.
    bool (*applies)(const Spec&) = nullptr;
};

template <class Spec, class Value>
Spec spec_of(Value Spec::*);
template <class Spec, class Value>
Value value_of(Value Spec::*);

/// `field<&GratingSpec::pitch_nm>({.key = "pitch_nm", …})`
template <auto Member>
constexpr auto field(FieldInfo info, bool (*applies)(const decltype(spec_of(Member))&) = nullptr)
{
    using Spec = decltype(spec_of(Member));
    info.type = field_type<decltype(value_of(Member))>();
    return Field<Spec>{info,
                       [](Section& section, const FieldInfo& of, Spec& spec) {
                           read_value(section, of, spec.*Member);
                       },
                       applies};
}

template <class Spec, std::size_t size>
void read_fields(Section& section, const std::array<Field<Spec>, size>& fields, Spec& spec)
{
    for (const Field<Spec>& field : fields)
        if (!field.applies || field.applies(spec)) field.read(section, field.info, spec);
}

/// What is known of the fields alone, in their order.
template <class Spec, std::size_t size>
std::vector<FieldInfo> infos(const std::array<Field<Spec>, size>& fields)
{
    std::vector<FieldInfo> result;
    for (const Field<Spec>& field : fields) result.push_back(field.info);
    return result;
}

}  // namespace nacre::material
