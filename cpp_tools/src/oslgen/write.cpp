// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/write.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <variant>

#include "nacre/core/version.h"
#include "writers.h"

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
        {"name", table.name()},
        {"role",
         {{"of", table_of_name(table.role.of)},
          {"content", table_content_name(table.role.content)},
          {"bare", table.role.is_bare}}},
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

std::span<const TableInfo> tables(const Program& program)
{
    const auto* surface = std::get_if<TableSurface>(&program.body);
    return surface ? std::span(surface->tables) : std::span<const TableInfo>();
}

Json gamut_entry(const Program& program)
{
    double lowest = 0.0;
    for (const TableInfo& table : tables(program))
        if (table.role.content != TableContent::powers) lowest = std::min(lowest, table.lowest);
    return {{"negative", lowest < 0.0}, {"lowest", lowest}};
}

Json held_entries(const Program& program)
{
    Json entries = Json::array();
    for (const HeldMedium& held : program.held)
        entries.push_back({{"medium", held.medium},
                           {"range_nm", held.range_nm},
                           {"percent", held.percent},
                           {"note", held.note}});
    return entries;
}

Json traits_entry(const Traits& traits)
{
    const std::string_view truth = truth_name(traits.truth);
    Json closures = Json::array();
    for (const Closure& closure : traits.closures)
        closures.push_back({{"output", closure.output}, {"role", closure_role_name(closure.role)}});
    return {{"stage", traits.stage},
            {"editable_stack", traits.editable_stack},
            {"probe", traits.probe},
            {"closures", std::move(closures)},
            {"truth", truth.empty() ? Json(nullptr) : Json(truth)},
            {"furnace", traits.is_body ? "body" : "surface"}};
}

Json manifest(const Program& program)
{
    const material::TemplateHead& head = program.head;
    const ColourSystem& colours = program.colours;
    Json result{{"schema", 1},
                {"id", head.id},
                {"name", head.name},
                {"kind", program.kind},
                {"category", head.category},
                {"description", head.description},
                {"source", head.source},
                {"status", material::status_name(head.status)},
                {"tags", head.tags},
                {"template", head.text},
                {"template_sha256", head.sha256},
                {"tool_version", version()},
                {"space", colours.space},
                {"to_xyz_d65", colours.to_xyz_d65},
                {"illuminant", colours.illuminant},
                {"observer", colours.observer},
                {"adaptation", colours.adaptation},
                {"wavelength_per_path", program.traits.wavelength_per_path},
                {"traits", traits_entry(program.traits)},
                {"gamut", gamut_entry(program)},
                {"sockets", Json::array()},
                {"tables", Json::array()},
                {"graphs", {{"osl", osl_graph(program)}, {"nodes", node_graph(program)}}}};
    if (Json bands = band_graph(program); !bands.is_null())
        result["graphs"]["bands"] = std::move(bands);
    for (const Socket& socket : program.sockets) result["sockets"].push_back(socket_entry(socket));
    for (const TableInfo& table : tables(program)) result["tables"].push_back(table_entry(table));
    if (head.look != material::LookSpec{})
        result["look"] = {{"object", head.look.object}, {"thickness", head.look.thickness}};
    if (!program.held.empty()) result["held_ends"] = held_entries(program);
    result.update(program.more);
    return result;
}

}  // namespace

ProgramText write(const Program& program)
{
    return {.osl = inline_includes(shader_text(program), program.head.id + ".osl"),
            .manifest = manifest(program).dump(2) + "\n"};
}

}  // namespace nacre::oslgen
