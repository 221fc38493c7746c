// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/schema.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "medium_forms.h"

namespace nacre::material {
namespace {

using Json = SchemaJson;

/// `Distance of neighbouring tracks, nm`
std::string description(const FieldInfo& info)
{
    return info.unit == "1" ? std::string(info.help) : fmt::format("{}, {}", info.help, info.unit);
}

Json described(Json schema, const std::string& text)
{
    if (!text.empty()) schema["description"] = text;
    return schema;
}

/// Whole numbers are written as such.
Json bound(double value)
{
    if (std::floor(value) == value && std::abs(value) < 1e15)
        return static_cast<std::int64_t>(value);
    return value;
}

Json bounded(const char* type, const Bounds& bounds)
{
    Json result{{"type", type}};
    if (std::isfinite(bounds.min))
        result[bounds.exclusive_min ? "exclusiveMinimum" : "minimum"] = bound(bounds.min);
    if (std::isfinite(bounds.max)) result["maximum"] = bound(bounds.max);
    return result;
}

Json text_schema()
{
    return {{"type", "string"}, {"minLength", 1}};
}

Json range_schema(const FieldInfo& info)
{
    const auto entry = [&](const char* text) {
        return described(bounded("number", info.bounds), text);
    };
    Json properties{{"default", entry("value of a fresh material")},
                    {"min", entry("lowest value of the slider")},
                    {"max", entry("highest value of the slider")}};
    Json required{"default"};
    if (info.slider == Slider::may)
        properties["varies"] = {{"type", "boolean"},
                                {"description", "becomes a slider and an axis of the table"}};
    else
        required = {"default", "min", "max"};
    return object_schema(std::move(properties), std::move(required));
}

Json terms(std::size_t most)
{
    return {
        {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 1}, {"maxItems", most}};
}

/// The keys of a medium; `exactly_one` says which of them decides.
Json medium_properties()
{
    const Json sellmeier_terms = terms(kMostSellmeierTerms);
    const Json sellmeier =
        object_schema({{"b", sellmeier_terms}, {"c", sellmeier_terms}}, {"b", "c"});
    const Json abbe =
        object_schema({{"n_d", described(bounded("number", kAbbe), "index at 587.56 nm")},
                       {"v_d", described(bounded("number", kAbbe), "Abbe number")}},
                      {"n_d", "v_d"});
    return {{"medium",
             described(text_schema(), "key of the library, as `nacre library list` shows it")},
            {"n", described(bounded("number", kMediumIndex), "constant index")},
            {"k", described(bounded("number", kMediumAbsorption), "absorption, with n or cauchy")},
            {"cauchy", described(terms(kMostCauchyTerms), "n = a + b/λ² + c/λ⁴, λ in µm")},
            {"sellmeier", described(sellmeier, "n² − 1 = Σ b λ²/(λ² − c), λ in µm, c in µm²")},
            {"abbe", abbe}};
}

}  // namespace

Json object_schema(Json properties, Json required)
{
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", std::move(required)},
            {"properties", std::move(properties)}};
}

Json reference_schema(const std::string& name)
{
    return {{"$ref", "#/$defs/" + name}};
}

Json field_schema(const FieldInfo& info)
{
    const auto plain = [&](Json schema) { return described(std::move(schema), description(info)); };
    switch (info.type) {
        case FieldType::number:
            return plain(bounded("number", info.bounds));
        case FieldType::integer:
            return plain(bounded("integer", info.bounds));
        case FieldType::boolean:
            return plain({{"type", "boolean"}});
        case FieldType::text:
            return plain(text_schema());
        case FieldType::texts:
            return plain({{"type", "array"}, {"items", text_schema()}});
        case FieldType::choice:
            return plain({{"enum", info.choices}});
        case FieldType::colour:
            return plain({{"type", "array"},
                          {"minItems", 3},
                          {"maxItems", 3},
                          {"items", bounded("number", info.bounds)}});
        case FieldType::quantity:
            return {{"oneOf",
                     Json::array({plain(bounded("number", info.bounds)), range_schema(info)})}};
        case FieldType::range:
            return plain(range_schema(info));
        case FieldType::medium:
            return reference_schema("medium");
    }
    return {};
}

Json fields_schema(std::span<const FieldInfo> fields)
{
    Json properties = Json::object(), required = Json::array();
    for (const FieldInfo& info : fields) {
        properties[std::string(info.key)] = field_schema(info);
        if (info.required) required.push_back(info.key);
    }
    return object_schema(std::move(properties), std::move(required));
}

Json medium_schema(std::span<const FieldInfo> more)
{
    Json result = fields_schema(more), properties = medium_properties();
    properties.update(result["properties"]);
    result["properties"] = std::move(properties);
    Json forms = Json::array();
    for (const std::string_view form : kMediumForms) forms.push_back({{"required", {form}}});
    result["oneOf"] = std::move(forms);
    return result;
}

}  // namespace nacre::material
