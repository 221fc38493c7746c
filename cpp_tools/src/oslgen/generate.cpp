// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "graph.h"
#include "nacre/core/version.h"
#include "nacre/oslgen/material_program.h"
#include "shader_text.h"

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

Json socket_entry(const Socket& socket)
{
    Json entry{{"name", socket.name},
               {"label", socket.label},
               {"type", socket.type},
               {"unit", socket.unit},
               {"description", socket.description}};
    if (socket.type == "color") entry["default"] = socket.colour;
    if (socket.type == "int") {
        entry["default"] = static_cast<int>(socket.value);
        entry["min"] = static_cast<int>(socket.min);
        entry["max"] = static_cast<int>(socket.max);
    }
    if (socket.type == "float") {
        entry["default"] = socket.value;
        entry["min"] = socket.min;
        entry["max"] = socket.max;
    }
    return entry;
}

Json axis_entry(const TableInfo::Axis& axis)
{
    return {{"name", axis.name},
            {"unit", axis.unit},
            {"min", axis.min},
            {"max", axis.max},
            {"mapping", "linear"}};
}

Json table_entry(const TableInfo& table)
{
    Json entry{
        {"name", table.name},
        {"file", table.file},
        {"quantity", table.quantity},
        {"width", table.x.texels},
        {"height", table.y.texels},
        {"axes", {axis_entry(table.x), axis_entry(table.y)}},
        {"error",
         {{"max", table.error_max}, {"mean", table.error_mean}, {"unit", table.error_unit}}}};
    if (table.slices > 1)
        entry["slices"] = {{"name", "roughness"},
                           {"count", table.slices},
                           {"min", 1.0 / table.slices},
                           {"max", 1.0}};
    if (table.sides > 1) entry["slices"]["sides"] = {"outside", "inside"};
    return entry;
}

Json gamut_entry(const Context& context)
{
    double lowest = 0.0;
    for (const TableInfo& table : context.tables)
        if (table.quantity != "schlick_coefficients") lowest = std::min(lowest, table.lowest);
    return {{"negative", lowest < 0.0}, {"lowest", lowest}};
}

Json held_entries(const Context& context)
{
    Json entries = Json::array();
    for (const HeldMedium& held : context.held)
        entries.push_back({{"medium", held.medium},
                           {"range_nm", held.range_nm},
                           {"percent", held.percent},
                           {"note", held.note}});
    return entries;
}

std::string kind_name(const Context& context)
{
    constexpr std::array<const char*, 3> kNames{"film", "grating", "glass"};
    return kNames[context.source->kind.index()];
}

/// What other programs may ask of a material without knowing its kind; see manifest.md.
Json traits(const Context& context)
{
    const bool film = std::holds_alternative<material::StackSpec>(context.source->kind);
    const bool body = std::holds_alternative<material::GlassSpec>(context.source->kind);
    return {{"stage", "shaderball"},
            {"editable_stack", film},
            {"probe", film},
            {"closures", {{{"output", "BSDF"}, {"role", "surface"}}}},
            {"truth", film   ? Json("stack")
                      : body ? Json("white")
                             : Json(nullptr)},
            {"furnace", body ? "body" : "surface"}};
}

Json manifest(const Context& context)
{
    const material::MaterialTemplate& source = *context.source;
    Json result{{"schema", 1},
                {"id", source.id},
                {"name", source.name},
                {"kind", kind_name(context)},
                {"category", source.category},
                {"description", source.description},
                {"source", source.source},
                {"status", material::status_name(source.status)},
                {"tags", source.tags},
                {"template", source.text},
                {"template_sha256", source.sha256},
                {"tool_version", version()},
                {"space", context.space},
                {"to_xyz_d65", context.to_xyz_d65},
                {"illuminant", context.illuminant},
                {"observer", context.observer},
                {"adaptation", context.adaptation},
                {"wavelength_per_path", context.wavelengths.has_value()},
                {"traits", traits(context)},
                {"gamut", gamut_entry(context)},
                {"sockets", Json::array()},
                {"tables", Json::array()},
                {"graphs", {{"osl", osl_graph(context)}, {"nodes", node_graph(context)}}}};
    for (const Socket& socket : sockets(context)) result["sockets"].push_back(socket_entry(socket));
    for (const TableInfo& table : context.tables) result["tables"].push_back(table_entry(table));
    if (const auto* stack = std::get_if<material::StackSpec>(&source.kind))
        result["technique"] = material::technique_name(stack->technique);
    if (context.schlick)
        result["schlick"] = {
            {"exponents", context.schlick->exponents},
            {"error", {{"max", context.schlick->error_max}, {"rms", context.schlick->error_rms}}}};
    if (context.glass)
        result["glass"] = {
            {"lines",
             {{"F", context.glass->n_F}, {"d", context.glass->n_d}, {"C", context.glass->n_C}}}};
    if (source.look != material::LookSpec{})
        result["look"] = {{"object", source.look.object}, {"thickness", source.look.thickness}};
    if (!context.held.empty()) result["held_ends"] = held_entries(context);
    if (const auto* grating = std::get_if<material::GratingSpec>(&source.kind))
        result["grating"] = {{"pitch_nm", grating->pitch_nm.value}, {"orders", grating->orders}};
    return result;
}

}  // namespace

MaterialProgram generate(const Context& context)
{
    return {.osl = inline_includes(shader_text(context), context.source->id + ".osl"),
            .manifest = manifest(context).dump(2) + "\n"};
}

}  // namespace nacre::oslgen
