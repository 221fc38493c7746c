// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/template.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "nacre/core/limits.h"
#include "nacre/core/sha256.h"
#include "read_kinds.h"
#include "toml_keys.h"
#include "toml_section.h"

namespace nacre::material {
namespace {

constexpr std::array<std::string_view, 3> kStatusNames{"measured", "sourced", "typical"};

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

std::string required_text(Section& section, std::string_view key)
{
    section.require(key, "a string");
    return section.text(key).value_or("");
}

void read_material(Section& root, MaterialTemplate& result)
{
    if (!root.require("material", "a table [material] with id, name, category, source")) return;
    auto section = root.section("material");
    if (!section) return;
    result.id = required_text(*section, "id");
    if (!result.id.empty() && !is_file_name_safe(result.id))
        section->report("id",
                        fmt::format("must be a to z, 0 to 9 and _, start with a letter and be "
                                    "at most 63 characters long (got \"{}\")",
                                    result.id));
    result.name = required_text(*section, "name");
    result.category = required_text(*section, "category");
    result.source = required_text(*section, "source");
    result.description = section->text("description").value_or("");
    if (const auto name = section->text("status")) {
        const auto status = std::ranges::find(kStatusNames, *name);
        if (status == kStatusNames.end())
            section->report("status", fmt::format("must be one of {} (got \"{}\")",
                                                  fmt::join(kStatusNames, ", "), *name));
        else
            result.status = static_cast<Status>(status - kStatusNames.begin());
    }
    result.tags = section->texts("tags").value_or(std::vector<std::string>{});
    section->report_unknown_keys();
}

std::optional<std::array<double, 3>> read_base(Section& section)
{
    const auto numbers = section.numbers("diffuse_base", 3, 3);
    if (!numbers) return std::nullopt;
    std::array<double, 3> base{};
    std::ranges::copy(*numbers, base.begin());
    constexpr Bounds kShare{0.0, 1.0};
    for (const double channel : base) {
        if (kShare.contains(channel)) continue;
        section.report("diffuse_base", fmt::format("{} (got {})", kShare.text(channel), channel));
        break;
    }
    return base;
}

void read_surface(Section& root, MaterialTemplate& result)
{
    auto section = root.section("surface");
    if (!section) return;
    result.surface.roughness = section->number("roughness", {0.0, 1.0}).value_or(0.0);
    if (std::holds_alternative<StackSpec>(result.kind)) {
        result.surface.anisotropy = section->number("anisotropy", {-0.9, 0.9});
        result.surface.transmission = section->boolean("transmission").value_or(false);
        if (result.surface.transmission && result.surface.anisotropy)
            section->report("anisotropy", "excludes transmission: glass has no brushed form");
        result.surface.diffuse_base = read_base(*section);
        if (result.surface.transmission && result.surface.diffuse_base)
            section->report("diffuse_base", "excludes transmission: nothing passes a matt base");
    }
    section->report_unknown_keys();
}

std::vector<std::string_view> known_parameters(const MaterialTemplate& result)
{
    if (std::holds_alternative<StackSpec>(result.kind)) return {"coverage", "roughness"};
    if (std::holds_alternative<GratingSpec>(result.kind)) return {"roughness", "strength"};
    return {"dispersion", "roughness"};
}

/// Sliders are shares, but dispersion may be exaggerated.
Bounds parameter_bounds(std::string_view name)
{
    return {0.0, name == "dispersion" ? 10.0 : 1.0};
}

void read_parameter(Section& section, MaterialTemplate& result)
{
    ParameterSpec parameter;
    parameter.line = section.line();
    parameter.name = required_text(section, "name");
    parameter.label = required_text(section, "label");
    parameter.description = section.text("description").value_or("");
    const auto known = known_parameters(result);
    if (!parameter.name.empty() && std::ranges::find(known, parameter.name) == known.end())
        section.report("name", fmt::format("unknown parameter; allowed here: {} (got \"{}\")",
                                           fmt::join(known, ", "), parameter.name));
    if (result.parameter(parameter.name))
        section.report("name", fmt::format("already declared (got \"{}\")", parameter.name));

    const Bounds bounds = parameter_bounds(parameter.name);
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
    result.parameters.push_back(std::move(parameter));
}

bool has_thickness_socket(const MaterialTemplate& result)
{
    const auto* stack = std::get_if<StackSpec>(&result.kind);
    return stack && (stack->varying_layer() || stack->scale);
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

void read_look(Section& root, MaterialTemplate& result)
{
    auto section = root.section("look");
    if (!section) return;
    result.look.object = section->text("object").value_or("");
    if (section->has("object") && !result.look.object.empty() && !is_plain_word(result.look.object))
        section->report("object", fmt::format("must be a word of a to z, 0 to 9 and _ (got \"{}\")",
                                              result.look.object));
    if (auto sources = section->texts("thickness")) {
        const auto wrong = std::ranges::find_if_not(*sources, is_source);
        if (wrong != sources->end())
            section->report(
                "thickness",
                fmt::format("must be SOURCE or SOURCE:NAME=VALUE,… (got \"{}\")", *wrong));
        else if (!has_thickness_socket(result))
            section->report("thickness", "needs a film whose thickness varies, or has a scale");
        result.look.thickness = std::move(*sources);
    }
    section->report_unknown_keys();
}

void read_template(Section& root, MaterialTemplate& result)
{
    root.require("schema", "1");
    root.integer("schema", 1, 1);
    read_material(root, result);
    result.kind = read_kind(root);
    read_surface(root, result);
    for (Section& section : root.sections("parameter")) read_parameter(section, result);
    read_look(root, result);
    root.report_unknown_keys();
}

}  // namespace

std::string_view status_name(Status status)
{
    return kStatusNames[static_cast<std::size_t>(status)];
}

std::optional<std::size_t> StackSpec::varying_layer() const
{
    const auto it = std::ranges::find_if(
        layers, [](const LayerSpec& layer) { return layer.thickness_nm.varies; });
    if (it == layers.end()) return std::nullopt;
    return static_cast<std::size_t>(it - layers.begin());
}

std::span<const std::string_view> technique_names()
{
    static constexpr std::array<std::string_view, 8> kNames{
        "multilayer",  "path_difference", "airy",   "series",
        "opaque_base", "free_film",       "etalon", "recursion"};
    return kNames;
}

std::string_view technique_name(Technique technique)
{
    return technique_names()[static_cast<std::size_t>(technique)];
}

const ParameterSpec* MaterialTemplate::parameter(std::string_view parameter_name) const
{
    const auto it = std::ranges::find(parameters, parameter_name, &ParameterSpec::name);
    return it == parameters.end() ? nullptr : &*it;
}

std::vector<const MediumSpec*> MaterialTemplate::media() const
{
    if (const auto* glass = std::get_if<GlassSpec>(&kind)) return {&glass->medium};
    if (const auto* grating = std::get_if<GratingSpec>(&kind))
        return {&grating->cover, &grating->substrate};
    const auto& stack = std::get<StackSpec>(kind);
    std::vector<const MediumSpec*> media{&stack.ambient};
    for (const LayerSpec& layer : stack.layers) media.push_back(&layer.medium);
    media.push_back(&stack.substrate);
    return media;
}

Interior MaterialTemplate::interior() const
{
    if (surface.diffuse_base) return Interior::diffuse;
    if (!surface.transmission) return Interior::opaque;
    const auto* stack = std::get_if<StackSpec>(&kind);
    const bool one_medium = !stack || stack->ambient.value == stack->substrate.value;
    return one_medium ? Interior::thin_wall : Interior::solid;
}

MaterialTemplate parse_template(std::string_view toml, std::string_view file)
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
    MaterialTemplate result;
    result.file = file;
    result.text = toml;
    result.sha256 = sha256_hex(toml);
    DiagnosticList problems;
    Section root(table, "", result.file, problems);
    read_template(root, result);
    problems.throw_first_if_any();
    return result;
}

}  // namespace nacre::material
