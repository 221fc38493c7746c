// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "brushed_nodes.h"
#include "nacre/oslgen/graph.h"
#include "writers.h"

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

/// Socket with |cos| of the angle of view; Geometry's Incoming points to the viewer.
std::string add_cosine(Graph& graph)
{
    graph.node("geometry", "ShaderNodeNewGeometry");
    graph.node("dot", "ShaderNodeVectorMath", {{"operation", "DOT_PRODUCT"}});
    graph.node("cos", "ShaderNodeMath", {{"operation", "ABSOLUTE"}});
    graph.link("geometry.Incoming", "dot.0");
    graph.link("input.normal", "dot.1");
    graph.link("dot.Value", "cos.0");
    return "cos.Value";
}

/// Socket with the cosine in the ambient, c: on back faces √(1 − n² (1 − c²)), and 0 where that has
/// no root, which is total reflection.
std::string add_ambient_cosine(Graph& graph, const std::string& cosine, double index)
{
    const auto math = [&graph](const std::string& id, const char* operation, Json values) {
        graph.node(id, "ShaderNodeMath", {{"operation", operation}}, std::move(values));
    };
    math("cos_squared", "MULTIPLY", Json::object());
    graph.link(cosine, "cos_squared.0");
    graph.link(cosine, "cos_squared.1");
    multiply_add(graph, "refracted", "cos_squared.Value", index * index, 1.0 - index * index);
    math("propagating", "MAXIMUM", {{"1", 0.0}});
    graph.link("refracted.Value", "propagating.0");
    math("cos_outside", "SQRT", Json::object());
    graph.link("propagating.Value", "cos_outside.0");
    graph.node("cos_ambient", "ShaderNodeMix", {{"data_type", "FLOAT"}});
    graph.link("geometry.Backfacing", "cos_ambient.Factor_Float");
    graph.link(cosine, "cos_ambient.A_Float");
    graph.link("cos_outside.Value", "cos_ambient.B_Float");
    return "cos_ambient.Result_Float";
}

/// Socket with the column of a slice of rough glass, after add_ambient_cosine(); see
/// nacre_glass_column().
std::string add_glass_column(Graph& graph, double index)
{
    const std::string id = "glass_column";
    if (!graph.first(id)) return id + ".Result_Float";
    Calculation calculate(graph);
    const double most = std::max(1e-6, index * index - 1.0);
    const std::string decay_squared =
        calculate.number("decay_squared", "MULTIPLY", {"refracted.Value", -1.0 / most}, true);
    const std::string decay = calculate.number("decay", "SQRT", {decay_squared});
    const std::string along = calculate.number("along", "SUBTRACT", {"cos_outside.Value", decay});
    const std::string inside = calculate.number("inside", "MULTIPLY_ADD", {along, 0.5, 0.5});
    graph.node(id, "ShaderNodeMix", {{"data_type", "FLOAT"}});
    graph.link("geometry.Backfacing", id + ".Factor_Float");
    graph.link("cos.Value", id + ".A_Float");
    graph.link(inside, id + ".B_Float");
    return id + ".Result_Float";
}

/// v that puts the ends of the second axis on the centres of the edge texels; beyond them the
/// image's extension holds the edge. Empty where there is one row.
std::string add_row(Graph& graph, const TableInfo& table)
{
    const double h = table.y.texels;
    if (table.y.texels == 1) return "";
    const std::string id = fmt::format("row_of_{}", table.y.texels);
    if (graph.first(id)) {
        const double slope = (h - 1.0) / (h * (table.y.max - table.y.min));
        multiply_add(graph, id, "input." + table.y.name, -slope,
                     1.0 - 0.5 / h + slope * table.y.min);
    }
    return id + ".Value";
}

/// Where a table is read; `u` is a socket, or empty where `constant_u` has it.
void add_position(Graph& graph, const std::string& id, const std::string& u, double constant_u,
                  const std::string& v)
{
    Json values = Json::object();
    if (u.empty()) values["X"] = constant_u;
    if (v.empty()) values["Y"] = 0.5;
    graph.node(id, "ShaderNodeCombineXYZ", Json::object(), std::move(values));
    if (!u.empty()) graph.link(u, id + ".X");
    if (!v.empty()) graph.link(v, id + ".Y");
}

void add_image(Graph& graph, const std::string& id, const TableInfo& table,
               const std::string& position)
{
    graph.image(id, table.name());
    graph.link(position + ".Vector", id + ".Vector");
}

/// Image nodes of the tables over the cosine, named as the tables; tables of one size share their
/// coordinates. What a lobe brings along is for the script, which alone has such a lobe.
enum class For { nodes, script };

bool is_of_lobe(TableOf of)
{
    return of == TableOf::lobe_R || of == TableOf::lobe_T;
}

void add_tables(Graph& graph, const TableSurface& surface, For whom)
{
    std::string cosine = add_cosine(graph);
    if (const auto index = surface.solid_index())
        cosine = add_ambient_cosine(graph, cosine, *index);
    for (const TableInfo& table : surface.tables) {
        if (table.role.content != TableContent::smooth) continue;
        if (is_of_lobe(table.role.of) && whom == For::nodes) continue;
        const std::string id = fmt::format("at_{}x{}", table.x.texels, table.y.texels);
        if (graph.first(id)) {
            const double w = table.x.texels;
            multiply_add(graph, id + "_u", cosine, (w - 1.0) / w, 0.5 / w);
            add_position(graph, id, id + "_u.Value", 0.0, add_row(graph, table));
        }
        add_image(graph, table.name(), table, id);
    }
}

/// Node `fraction`, the share of the slice above `floor` in what is read at `level`, as
/// nacre_slice_share() has it.
void add_slice_share(Calculation& calculate, const std::string& prefix, const std::string& level,
                     const std::string& floor)
{
    const auto math = [&](const char* id, const char* operation,
                          const std::vector<Json>& operands) {
        return calculate.number(prefix + id, operation, operands);
    };
    const std::string at = math("at_power", "POWER", {level, 4.0});
    const std::string low = math("low_power", "POWER", {floor, 4.0});
    const std::string next = math("next_level", "ADD", {floor, 1.0});
    const std::string high = math("high_power", "POWER", {next, 4.0});
    const std::string beyond = math("beyond", "SUBTRACT", {at, low});
    const std::string span = math("span", "SUBTRACT", {high, low});
    math("fraction", "DIVIDE", {beyond, span});
}

/// The same for rough tables: `low` and `high`, the shares of the image's width where the slices
/// below and above the roughness begin, and `fraction`, where between them it lies. Below the first
/// slice, `is_smooth`, the smooth table takes the place of the lower one. The second side, seen
/// from inside, has the right half.
void add_level(Graph& graph, const std::string& prefix, const std::string& roughness,
               const TableInfo& table)
{
    Calculation calculate(graph);
    const auto math = [&](const char* id, const char* operation, const std::vector<Json>& operands,
                          bool clamped = false) {
        return calculate.number(prefix + id, operation, operands, clamped);
    };
    const double n = table.slices, all = n * table.sides;
    const std::string held = math("held", "ADD", {roughness, 0.0}, true);
    const std::string level = math("level", "MULTIPLY", {held, n});
    const std::string floor = math("floor", "FLOOR", {level});
    add_slice_share(calculate, prefix, level, floor);
    math("is_smooth", "LESS_THAN", {level, 1.0});
    const std::string lower = math("lower", "MULTIPLY_ADD", {floor, 1.0 / all, -1.0 / all});
    const std::string low = math("low", "MAXIMUM", {lower, 0.0});
    const std::string upper = math("upper", "MULTIPLY", {floor, 1.0 / all});
    const std::string high = math("high", "MINIMUM", {upper, (n - 1.0) / all});
    if (table.sides == 1) return;
    math("low_of_side", "MULTIPLY_ADD", {"geometry.Backfacing", 0.5, low});
    math("high_of_side", "MULTIPLY_ADD", {"geometry.Backfacing", 0.5, high});
}

/// Prefixes of the nodes of the roughness at which a brushed surface's tables are read.
constexpr const char *kSeen = "", *kFurther = "further_";

std::string roughness_of(Graph& graph, const TableSurface& surface, const std::string& level)
{
    if (!surface.is_brushed) return "input.roughness";
    if (graph.first("seen")) add_brushed_facets(graph);
    return level.empty() ? "seen.Value" : "further.Value";
}

/// Positions `<id>_low` and `<id>_high` in a rough table.
std::string add_slice_positions(Graph& graph, const TableSurface& surface, const TableInfo& table,
                                const std::string& level)
{
    std::string id = fmt::format("{}slices_{}x{}", level, table.x.texels, table.y.texels);
    if (!graph.first(id)) return id;
    if (graph.first(level + "level"))
        add_level(graph, level, roughness_of(graph, surface, level), table);
    const double columns = table.x.texels, width = columns / (table.sides * table.slices);
    const auto solid = surface.solid_index();
    const std::string cosine = solid                ? add_glass_column(graph, *solid)
                               : surface.is_brushed ? "cos_seen.Value"
                                                    : "cos.Value";
    const std::string of_side = table.sides > 1 ? "_of_side.Value" : ".Value";
    multiply_add(graph, id + "_in", cosine, (width - 1.0) / columns, 0.5 / columns);
    const std::string row = add_row(graph, table);
    Calculation calculate(graph);
    for (const std::string end : {"low", "high"}) {
        const std::string u =
            calculate.number(fmt::format("{}_u_{}", id, end), "ADD",
                             {id + "_in.Value", fmt::format("{}{}{}", level, end, of_side)});
        add_position(graph, fmt::format("{}_{}", id, end), u, 0.0, row);
    }
    return id;
}

/// Mix of two colours: sockets, or empty for black.
std::string add_mix(Graph& graph, const std::string& id, const std::string& factor,
                    const std::string& a, const std::string& b)
{
    Json values = Json::object();
    if (a.empty()) values["A_Color"] = {0.0, 0.0, 0.0, 1.0};
    if (b.empty()) values["B_Color"] = {0.0, 0.0, 0.0, 1.0};
    graph.node(id, "ShaderNodeMix", {{"data_type", "RGBA"}, {"blend_type", "MIX"}},
               std::move(values));
    graph.link(factor, id + ".Factor_Float");
    if (!a.empty()) graph.link(a, id + ".A_Color");
    if (!b.empty()) graph.link(b, id + ".B_Color");
    return id + ".Result_Color";
}

/// The colour of a rough table at the roughness; `smooth` is a socket, or empty for black.
std::string add_roughened(Graph& graph, const TableSurface& surface, const TableInfo& table,
                          const std::string& smooth, const std::string& level)
{
    const std::string id = level + table.name();
    if (!graph.first(id)) return id + "_mixed.Result_Color";
    const std::string at = add_slice_positions(graph, surface, table, level);
    const std::string low = id + "_low", high = id + "_high";
    add_image(graph, low, table, at + "_low");
    add_image(graph, high, table, at + "_high");
    const std::string below =
        add_mix(graph, id + "_below", level + "is_smooth.Value", low + ".Color", smooth);
    return add_mix(graph, id + "_mixed", level + "fraction.Value", below, high + ".Color");
}

/// A vector operation on colours; operands are sockets, or none where `values` has them.
std::string add_colour_math(Graph& graph, const std::string& id, const char* operation,
                            const std::string& a, const std::string& b,
                            Json values = Json::object())
{
    graph.node(id, "ShaderNodeVectorMath", {{"operation", operation}}, std::move(values));
    if (!a.empty()) graph.link(a, id + ".0");
    if (!b.empty()) graph.link(b, id + ".1");
    return id + ".Vector";
}

/// What leaves after two and more bounces.
std::string add_further(Graph& graph, const TableSurface& surface, const TableInfo& table)
{
    if (!surface.is_brushed) return add_roughened(graph, surface, table, "", kSeen);
    const std::string id = table.name() + "_scaled";
    if (!graph.first(id)) return id + ".Vector";
    const std::string colour = add_roughened(graph, surface, table, "", kFurther);
    graph.link("further_scale.Value", id + ".Scale");
    return add_colour_math(graph, id, "SCALE", colour, "");
}

/// Socket with the colour of one quantity and substrate, `R` or `R_bare`, at the roughness.
std::string add_colour(Graph& graph, const TableSurface& surface, const TableColour& colour)
{
    std::string smooth = colour.smooth.name() + ".Color";
    if (!colour.rough) return smooth;
    std::string mean = add_roughened(graph, surface, *colour.rough, smooth, kSeen);
    if (!colour.further) return mean;
    const std::string suffix = colour.smooth.role.is_bare ? "_bare" : "";
    const std::string once =
        add_colour_math(graph, "once" + suffix, "SUBTRACT", mean,
                        add_roughened(graph, surface, *colour.further, "", kSeen));
    return add_colour_math(graph, "all_bounces" + suffix, "ADD", once,
                           add_further(graph, surface, *colour.further));
}

/// Output socket with the colour of R or T, faded to the bare substrate by the coverage.
std::string add_faded(Graph& graph, const TableSurface& surface, TableOf of)
{
    const FadedColour colour = surface.faded(of);
    std::string film = add_colour(graph, surface, colour.film);
    if (!colour.bare) return film;
    return add_mix(graph, colour.film.smooth.name() + "_faded", "input.coverage",
                   add_colour(graph, surface, *colour.bare), film);
}

/// T · base · T_inner / (1 − base · R_inner), as nacre_base_colour() has it.
std::string add_base_colour(Graph& graph, const TableSurface& surface)
{
    const std::string returned = add_colour_math(graph, "returned", "MULTIPLY", "input.base_colour",
                                                 add_faded(graph, surface, TableOf::R_inner));
    const std::string rest =
        add_colour_math(graph, "rest", "SUBTRACT", "", returned, {{"0", {1.0, 1.0, 1.0}}});
    const std::string leaving = add_colour_math(graph, "leaving", "MULTIPLY", "input.base_colour",
                                                add_faded(graph, surface, TableOf::T_inner));
    const std::string passing = add_colour_math(graph, "passing", "MULTIPLY", leaving,
                                                add_faded(graph, surface, TableOf::T));
    return add_colour_math(graph, "base", "DIVIDE", passing, rest);
}

/// What passes the film, less what Cycles adds to the reflection where it cuts its negative
/// channels: together they send on what the exact colours do.
std::string without_the_cut(Graph& graph, const TableSurface& surface, const std::string& reflected,
                            const std::string& passing)
{
    if (!surface.has_negative()) return passing;
    const std::string cut =
        add_colour_math(graph, "cut", "MINIMUM", reflected, "", {{"1", {0.0, 0.0, 0.0}}});
    return add_colour_math(graph, "passing_less_cut", "ADD", passing, cut);
}

/// Adds the shader for what passes the surface that reflects the colour of socket `reflected`, and
/// returns its output; empty where nothing does.
struct BelowTheSurface {
    Graph& graph;
    const TableSurface& surface;
    const std::string& reflected;

    std::string operator()(const OpaqueBase&) const { return ""; }
    std::string operator()(const ThinWall&) const
    {
        graph.node("transmission", "ShaderNodeBsdfTransparent");
        return coloured(add_faded(graph, surface, TableOf::T), "transmission");
    }
    std::string operator()(const SolidGlass& glass) const
    {
        graph.node("transmission", "ShaderNodeBsdfRefraction", {{"distribution", "GGX"}},
                   {{"IOR", glass.index}});
        graph.link("input.roughness", "transmission.Roughness");
        graph.link("input.normal", "transmission.Normal");
        return coloured(add_faded(graph, surface, TableOf::T), "transmission");
    }
    std::string operator()(const MattBase&) const
    {
        graph.node("matt", "ShaderNodeBsdfDiffuse");
        graph.link("input.normal", "matt.Normal");
        return coloured(add_base_colour(graph, surface), "matt");
    }

private:
    [[nodiscard]] std::string coloured(const std::string& passing, const std::string& shader) const
    {
        graph.link(without_the_cut(graph, surface, reflected, passing), shader + ".Color");
        return shader + ".BSDF";
    }
};

struct NodeForm {
    Json operator()(const TableSurface& surface) const { return surface_nodes(surface); }
    Json operator()(const ShaderBody& body) const
    {
        const auto* graph = std::get_if<Graph>(&body.nodes);
        return graph ? graph->json() : Json(nullptr);
    }
    Json operator()(const ShaderText& shader) const { return shader.nodes.value_or(Json(nullptr)); }
};

struct BandForm {
    Json operator()(const TableSurface&) const { return nullptr; }
    Json operator()(const ShaderBody& body) const
    {
        return body.bands ? body.bands->json() : Json(nullptr);
    }
    Json operator()(const ShaderText& shader) const { return shader.bands.value_or(Json(nullptr)); }
};

}  // namespace

Json surface_nodes(const TableSurface& surface)
{
    Graph graph;
    add_tables(graph, surface, For::nodes);
    graph.node("reflection", "ShaderNodeBsdfAnisotropic", {{"distribution", "GGX"}});
    const std::string reflected = add_faded(graph, surface, TableOf::R);
    graph.link(reflected, "reflection.Color");
    graph.link("input.roughness", "reflection.Roughness");
    graph.link("input.normal", "reflection.Normal");
    if (surface.is_brushed) {
        graph.link("input.anisotropy", "reflection.Anisotropy");
        graph.link("input.rotation", "reflection.Rotation");
        graph.link("input.tangent", "reflection.Tangent");
    }
    const std::string below = std::visit(BelowTheSurface{graph, surface, reflected}, surface.below);
    if (below.empty()) {
        graph.link("reflection.BSDF", "output.BSDF");
        return graph.json();
    }
    graph.node("sum", "ShaderNodeAddShader");
    graph.link("reflection.BSDF", "sum.0");
    graph.link(below, "sum.1");
    graph.link("sum.Shader", "output.BSDF");
    return graph.json();
}

void add_looked_up(Graph& graph, const TableSurface& surface)
{
    add_tables(graph, surface, For::script);
    graph.node("script", "ShaderNodeScript");
    const auto feed = [&](const std::string& from, const std::string& name) {
        graph.link(from, fmt::format("script.{}_in", name));
    };
    for (const TableInfo& table : surface.tables) {
        const TableRole& role = table.role;
        if (role.content == TableContent::powers) {
            const std::string row = add_row(graph, table);
            for (int k = 0; k < table.x.texels; ++k) {
                const std::string id = fmt::format("{}_{}", table.name(), k);
                add_position(graph, id + "_at", "", (k + 0.5) / table.x.texels, row);
                add_image(graph, id, table, id + "_at");
                feed(id + ".Color", id);
            }
        } else if (role.content == TableContent::further) {
            feed(add_further(graph, surface, table), table.name());
        } else if (role.content == TableContent::smooth) {
            feed(add_colour(graph, surface, surface.colour(role.of, role.is_bare)), table.name());
        }
    }
}

Json osl_graph(const Program& program)
{
    Graph graph;
    if (const auto* surface = std::get_if<TableSurface>(&program.body))
        add_looked_up(graph, *surface);
    else
        graph.node("script", "ShaderNodeScript");
    for (const Socket& socket : program.sockets)
        graph.link("input." + socket.name, fmt::format("script.{}", parameter_name(socket)));
    for (const Closure& closure : program.traits.closures)
        graph.link("script." + closure.output, "output." + closure.output);
    return graph.json();
}

Json node_graph(const Program& program)
{
    return std::visit(NodeForm{}, program.body);
}

Json band_graph(const Program& program)
{
    return std::visit(BandForm{}, program.body);
}

}  // namespace nacre::oslgen
