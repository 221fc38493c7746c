// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "graph.h"

#include <fmt/format.h>

#include <set>
#include <variant>

#include "shader_text.h"

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

/// Collects nodes and links in the form of the manifest.
class Graph {
public:
    void node(std::string id, std::string type, Json properties = Json::object(),
              Json values = Json::object())
    {
        Json entry{{"id", std::move(id)}, {"type", std::move(type)}};
        if (!properties.empty()) entry["properties"] = std::move(properties);
        if (!values.empty()) entry["values"] = std::move(values);
        nodes_.push_back(std::move(entry));
    }

    void image(const std::string& table)
    {
        nodes_.push_back({{"id", table}, {"type", "ShaderNodeTexImage"}, {"table", table}});
    }

    void link(std::string from, std::string to)
    {
        links_.push_back(Json::array({std::move(from), std::move(to)}));
    }

    [[nodiscard]] Json json() const { return {{"nodes", nodes_}, {"links", links_}}; }

private:
    Json nodes_ = Json::array(), links_ = Json::array();
};

/// value * factor + offset
void multiply_add(Graph& graph, const std::string& id, const std::string& from, double factor,
                  double offset)
{
    graph.node(id, "ShaderNodeMath", {{"operation", "MULTIPLY_ADD"}},
               {{"1", factor}, {"2", offset}});
    graph.link(from, id + ".0");
}

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

/// u and v that put the ends of both axes on the centres of the edge texels; beyond them the
/// image's extension holds the edge.
void add_coordinates(Graph& graph, const std::string& id, const TableInfo& table,
                     const std::string& cosine)
{
    const double w = table.x.texels, h = table.y.texels;
    multiply_add(graph, id + "_u", cosine, (w - 1.0) / w, 0.5 / w);
    if (table.y.texels == 1) {
        graph.node(id + "_uv", "ShaderNodeCombineXYZ", Json::object(), {{"Y", 0.5}});
    } else {
        const double slope = (h - 1.0) / (h * (table.y.max - table.y.min));
        multiply_add(graph, id + "_v", "input." + table.y.name, -slope,
                     1.0 - 0.5 / h + slope * table.y.min);
        graph.node(id + "_uv", "ShaderNodeCombineXYZ");
        graph.link(id + "_v.Value", id + "_uv.Y");
    }
    graph.link(id + "_u.Value", id + "_uv.X");
}

/// Image nodes of all tables, named as the tables; tables of one size share their coordinates.
void add_tables(Graph& graph, const Context& context)
{
    std::string cosine = add_cosine(graph);
    if (context.solid_index) cosine = add_ambient_cosine(graph, cosine, *context.solid_index);
    std::set<std::string> coordinates;
    for (const TableInfo& table : context.tables) {
        const std::string id = fmt::format("at_{}x{}", table.x.texels, table.y.texels);
        if (coordinates.insert(id).second) add_coordinates(graph, id, table, cosine);
        graph.image(table.name);
        graph.link(id + "_uv.Vector", table.name + ".Vector");
    }
}

/// Output socket with the colour of R or T, faded to the bare substrate by the coverage.
std::string faded(Graph& graph, const Context& context, const std::string& name)
{
    if (!find_table(context, name + "_bare")) return name + ".Color";
    const std::string mix = name + "_faded";
    graph.node(mix, "ShaderNodeMix", {{"data_type", "RGBA"}, {"blend_type", "MIX"}});
    graph.link("input.coverage", mix + ".Factor_Float");
    graph.link(name + "_bare.Color", mix + ".A_Color");
    graph.link(name + ".Color", mix + ".B_Color");
    return mix + ".Result_Color";
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

/// T · base · T_inner / (1 − base · R_inner), as nacre_base_colour() has it.
std::string add_base_colour(Graph& graph, const Context& context)
{
    const std::string returned = add_colour_math(graph, "returned", "MULTIPLY", "input.base_colour",
                                                 faded(graph, context, "R_inner"));
    const std::string rest =
        add_colour_math(graph, "rest", "SUBTRACT", "", returned, {{"0", {1.0, 1.0, 1.0}}});
    const std::string leaving = add_colour_math(graph, "leaving", "MULTIPLY", "input.base_colour",
                                                faded(graph, context, "T_inner"));
    const std::string passing =
        add_colour_math(graph, "passing", "MULTIPLY", leaving, faded(graph, context, "T"));
    return add_colour_math(graph, "base", "DIVIDE", passing, rest);
}

/// The shader for what passes the film; empty where nothing does.
std::string add_below_the_film(Graph& graph, const Context& context)
{
    switch (context.source->interior()) {
        case material::Interior::opaque:
            return "";
        case material::Interior::thin_wall:
            graph.node("transmission", "ShaderNodeBsdfTransparent");
            graph.link(faded(graph, context, "T"), "transmission.Color");
            return "transmission.BSDF";
        case material::Interior::solid:
            graph.node("transmission", "ShaderNodeBsdfRefraction", {{"distribution", "GGX"}},
                       {{"IOR", context.solid_index.value()}});
            graph.link(faded(graph, context, "T"), "transmission.Color");
            graph.link("input.roughness", "transmission.Roughness");
            graph.link("input.normal", "transmission.Normal");
            return "transmission.BSDF";
        case material::Interior::diffuse:
            graph.node("matt", "ShaderNodeBsdfDiffuse");
            graph.link(add_base_colour(graph, context), "matt.Color");
            graph.link("input.normal", "matt.Normal");
            return "matt.BSDF";
    }
    return "";
}

Json film_nodes(const Context& context)
{
    Graph graph;
    add_tables(graph, context);
    graph.node("reflection", "ShaderNodeBsdfAnisotropic", {{"distribution", "GGX"}});
    graph.link(faded(graph, context, "R"), "reflection.Color");
    graph.link("input.roughness", "reflection.Roughness");
    graph.link("input.normal", "reflection.Normal");
    const std::string below = add_below_the_film(graph, context);
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

/// Without a wavelength per path there is no dispersion: plain glass with the index of the d line.
Json glass_nodes(const Context& context)
{
    Graph graph;
    graph.node("glass", "ShaderNodeBsdfGlass", {{"distribution", "GGX"}},
               {{"IOR", context.glass->n_d}});
    graph.link("input.roughness", "glass.Roughness");
    graph.link("input.normal", "glass.Normal");
    graph.link("glass.BSDF", "output.BSDF");
    return graph.json();
}

}  // namespace

Json osl_graph(const Context& context)
{
    Graph graph;
    if (!context.tables.empty()) add_tables(graph, context);
    graph.node("script", "ShaderNodeScript");
    for (const TableInfo& table : context.tables)
        graph.link(table.name + ".Color", fmt::format("script.{}_in", table.name));
    for (const Socket& socket : sockets(context))
        graph.link("input." + socket.name, fmt::format("script.{}", parameter_name(socket)));
    graph.link("script.BSDF", "output.BSDF");
    return graph.json();
}

Json node_graph(const Context& context)
{
    if (std::holds_alternative<material::StackSpec>(context.source->kind))
        return film_nodes(context);
    if (std::holds_alternative<material::GlassSpec>(context.source->kind))
        return glass_nodes(context);
    return nullptr;
}

}  // namespace nacre::oslgen
