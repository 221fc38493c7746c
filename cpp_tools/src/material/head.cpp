// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/head.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace nacre::material {
namespace {

constexpr std::array<std::string_view, 3> kStatusNames{"measured", "sourced", "typical"};

constexpr std::array kMaterialFields{
    field<&TemplateHead::id>(
        {.key = "id", .help = "a to z, 0 to 9 and _, a letter first", .required = true}),
    field<&TemplateHead::name>({.key = "name", .help = "as the artist reads it", .required = true}),
    field<&TemplateHead::category>(
        {.key = "category", .help = "path in the asset catalogue", .required = true}),
    field<&TemplateHead::source>({.key = "source",
                                  .help = "where the values come from, and which are only typical",
                                  .required = true}),
    field<&TemplateHead::description>({.key = "description", .help = "one sentence"}),
    field<&TemplateHead::status>({.key = "status",
                                  .help = "how far the values can be trusted; else typical",
                                  .choices = kStatusNames}),
    field<&TemplateHead::tags>({.key = "tags", .help = "for searches"}),
};

constexpr std::array kSurfaceFields{field<&TemplateHead::roughness>(
    {.key = "roughness", .help = "Blender's: GGX alpha is the square", .bounds = {0.0, 1.0}})};

constexpr std::array kParameterTexts{
    field<&ParameterSpec::name>({.key = "name", .help = "of the slider", .required = true}),
    field<&ParameterSpec::label>(
        {.key = "label", .help = "as the artist reads it", .required = true}),
    field<&ParameterSpec::description>({.key = "description", .help = "tooltip"}),
};

constexpr std::array kLookFields{
    field<&LookSpec::object>(
        {.key = "object", .help = "what the material is pictured on, such as blade"}),
    field<&LookSpec::thickness>(
        {.key = "thickness", .help = "what the thickness follows, the lowest source first"}),
};

/// Of all sliders, each once.
std::vector<std::string_view> sorted_names(std::span<const SliderInfo> sliders)
{
    std::set<std::string_view> names;
    for (const SliderInfo& slider : sliders) names.insert(slider.name);
    return {names.begin(), names.end()};
}

/// a to z, 0 to 9 and _, a letter first.
bool is_plain_word(std::string_view word)
{
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !word.empty() && word.front() >= 'a' && word.front() <= 'z' &&
           std::ranges::all_of(word, allowed);
}

bool is_file_name_safe(std::string_view id)
{
    return id.size() <= 63 && is_plain_word(id);
}

void read_parameter(Section& section, std::span<const SliderInfo> sliders, TemplateHead& head)
{
    ParameterSpec parameter;
    parameter.line = section.line();
    read_fields(section, kParameterTexts, parameter);
    const auto slider = std::ranges::find(sliders, parameter.name, &SliderInfo::name);
    if (!parameter.name.empty() && slider == sliders.end())
        section.report("name", fmt::format("unknown parameter; allowed here: {} (got \"{}\")",
                                           fmt::join(sorted_names(sliders), ", "), parameter.name));
    if (head.parameter(parameter.name))
        section.report("name", fmt::format("already declared (got \"{}\")", parameter.name));

    const Bounds bounds{0.0, slider == sliders.end() ? 1.0 : slider->most};
    section.require("default", "a number");
    const auto value = section.number("default", bounds);
    parameter.min = section.number("min", bounds).value_or(0.0);
    parameter.max = section.number("max", bounds).value_or(1.0);
    if (parameter.min >= parameter.max)
        section.report(
            "min", fmt::format("must be below max (got {} and {})", parameter.min, parameter.max));
    else if (value && (*value < parameter.min || *value > parameter.max))
        section.report("default", fmt::format("must be in [{}, {}] (got {})", parameter.min,
                                              parameter.max, *value));
    parameter.value = value.value_or(0.0);
    section.report_unknown_keys();
    head.parameters.push_back(std::move(parameter));
}

/// `drop`, or `drop:base_nm=100,centre=0.3:0.6`; which sources there are is for those to say who
/// have them.
bool is_source(std::string_view text)
{
    const auto colon = text.find(':');
    if (!is_plain_word(text.substr(0, colon))) return false;
    if (colon == std::string_view::npos) return true;
    std::string_view values = text.substr(colon + 1);
    for (;;) {
        const auto comma = values.find(',');
        const std::string_view value = values.substr(0, comma);
        const auto equals = value.find('=');
        if (equals == std::string_view::npos || !is_plain_word(value.substr(0, equals)) ||
            equals + 1 == value.size())
            return false;
        if (comma == std::string_view::npos) return true;
        values.remove_prefix(comma + 1);
    }
}

SchemaJson parameter_schema(std::span<const SliderInfo> sliders)
{
    Bounds bounds{0.0, 0.0};
    for (const SliderInfo& slider : sliders) bounds.max = std::max(bounds.max, slider.most);
    std::vector<FieldInfo> fields = infos(kParameterTexts);
    const auto names = sorted_names(sliders);
    fields.front().type = FieldType::choice;
    fields.front().choices = names;
    const auto number = [&](std::string_view key, std::string_view help) {
        fields.push_back({.key = key, .help = help, .bounds = bounds});
    };
    number("default", "value of a fresh material");
    fields.back().required = true;
    number("min", "lowest value of the slider, 0");
    number("max", "highest value of the slider, 1");
    return fields_schema(fields);
}

SchemaJson look_schema()
{
    SchemaJson result = fields_schema(infos(kLookFields));
    result["properties"]["object"]["pattern"] = "^[a-z][a-z0-9_]*$";
    result["properties"]["thickness"]["items"]["pattern"] =
        "^[a-z][a-z0-9_]*(:[a-z][a-z0-9_]*=[^,]+(,[a-z][a-z0-9_]*=[^,]+)*)?$";
    return result;
}

}  // namespace

std::string_view status_name(Status status)
{
    return kStatusNames[static_cast<std::size_t>(status)];
}

const ParameterSpec* TemplateHead::parameter(std::string_view parameter_name) const
{
    const auto it = std::ranges::find(parameters, parameter_name, &ParameterSpec::name);
    return it == parameters.end() ? nullptr : &*it;
}

std::string id_problem(std::string_view id)
{
    if (is_file_name_safe(id)) return "";
    return fmt::format(
        "must be a to z, 0 to 9 and _, start with a letter and be at most 63 "
        "characters long (got \"{}\")",
        id);
}

void read_material(Section& root, TemplateHead& head)
{
    if (!root.require("material", "a table [material] with id, name, category, source")) return;
    auto section = root.section("material");
    if (!section) return;
    for (const auto& field : kMaterialFields) {
        field.read(*section, field.info, head);
        if (field.info.key != "id" || head.id.empty()) continue;
        if (std::string problem = id_problem(head.id); !problem.empty())
            section->report("id", std::move(problem));
    }
    section->report_unknown_keys();
}

void read_surface(Section& root, TemplateHead& head, const std::function<void(Section&)>& read_more)
{
    auto section = root.section("surface");
    if (!section) return;
    read_fields(*section, kSurfaceFields, head);
    read_more(*section);
    section->report_unknown_keys();
}

void read_parameters(Section& root, std::span<const SliderInfo> sliders, TemplateHead& head)
{
    for (Section& section : root.sections("parameter")) read_parameter(section, sliders, head);
}

void read_look(Section& root, bool has_thickness, TemplateHead& head)
{
    auto section = root.section("look");
    if (!section) return;
    read_fields(*section, kLookFields, head.look);
    const LookSpec& look = head.look;
    if (!look.object.empty() && !is_plain_word(look.object))
        section->report("object", fmt::format("must be a word of a to z, 0 to 9 and _ (got \"{}\")",
                                              look.object));
    const auto wrong = std::ranges::find_if_not(look.thickness, is_source);
    if (wrong != look.thickness.end())
        section->report("thickness",
                        fmt::format("must be SOURCE or SOURCE:NAME=VALUE,… (got \"{}\")", *wrong));
    else if (section->has("thickness") && !has_thickness)
        section->report("thickness", "needs a film whose thickness varies, or has a scale");
    section->report_unknown_keys();
}

SchemaJson head_schema(std::span<const FieldInfo> surface, std::span<const SliderInfo> sliders)
{
    SchemaJson material = fields_schema(infos(kMaterialFields));
    material["properties"]["id"]["pattern"] = "^[a-z][a-z0-9_]{0,62}$";
    std::vector<FieldInfo> all = infos(kSurfaceFields);
    all.insert(all.end(), surface.begin(), surface.end());
    return {{"material", std::move(material)},
            {"surface", fields_schema(all)},
            {"parameter", {{"type", "array"}, {"items", parameter_schema(sliders)}}},
            {"look", look_schema()}};
}

}  // namespace nacre::material
