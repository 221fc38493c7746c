// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/material/schema.h"
#include "nacre/material/section.h"

/// @file
/// What every template says, whatever the material is made of.

namespace nacre::material {

/// A slider that materials of a kind have, and that `[[parameter]]` may give another label, range
/// or default.
struct SliderInfo {
    std::string_view name;
    std::string_view label{}, help{};
    double value = 0.0;
    double max = 1.0;   ///< where the template says nothing
    double most = 1.0;  ///< that the template may say
    /// Whether materials have it only where the template declares it.
    bool is_declared = false;
};

/// A slider as a template's `[[parameter]]` has it.
struct ParameterSpec {
    std::string name, label, description;
    double value = 0.0, min = 0.0, max = 1.0;
    int line = 0;
};

/// How far the values of a material can be trusted.
enum class Status {
    measured,  ///< the stack was measured on one specimen, and so were its media
    sourced,   ///< each value has a source
    typical,   ///< some values are only of the right size
};

[[nodiscard]] std::string_view status_name(Status status);

/// How the material looks its best. The library does not read it: who makes pictures does.
struct LookSpec {
    std::string object;                  ///< what it is pictured on, such as `blade`; may be empty
    std::vector<std::string> thickness;  ///< sources of a thickness, `SOURCE[:NAME=VALUE,…]`

    bool operator==(const LookSpec&) const = default;
};

struct TemplateHead {
    std::string id, name, category, description, source;
    Status status = Status::typical;
    std::vector<std::string> tags;  ///< for searches
    double roughness = 0.0;         ///< Blender's
    std::vector<ParameterSpec> parameters;
    LookSpec look;

    [[nodiscard]] const ParameterSpec* parameter(std::string_view parameter_name) const;

    std::string file;    ///< for messages
    std::string text;    ///< the template's bytes
    std::string sha256;  ///< of them
};

/// What is wrong with a material's id, which names files; empty where nothing is.
[[nodiscard]] std::string id_problem(std::string_view id);

/// `[material]`
void read_material(Section& root, TemplateHead& head);

/// `[surface]`; `read_more` reads what a kind has there beside the roughness.
void read_surface(
    Section& root, TemplateHead& head,
    const std::function<void(Section&)>& read_more = [](Section&) {});

/// Every `[[parameter]]`, each of one of these sliders.
void read_parameters(Section& root, std::span<const SliderInfo> sliders, TemplateHead& head);

/// `[look]`
/// @param has_thickness  whether there is a socket that sources of a thickness can drive
void read_look(Section& root, bool has_thickness, TemplateHead& head);

/// Entries of the JSON schema: `material`, `surface` with the fields of all kinds, `parameter` with
/// the names of all of them, `look`.
[[nodiscard]] SchemaJson head_schema(std::span<const FieldInfo> surface,
                                     std::span<const SliderInfo> sliders);

/// The roughness, which all materials have.
inline constexpr SliderInfo kRoughness{
    .name = "roughness", .label = "Roughness", .help = "0: mirror; GGX alpha is the square"};

}  // namespace nacre::material
