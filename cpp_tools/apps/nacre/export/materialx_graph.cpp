// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "export/materialx_graph.h"

#include <fmt/format.h>

namespace nacre::tool {
namespace {

std::string digits(double number)
{
    return fmt::format("{:.9g}", number);
}

}  // namespace

pugi::xml_node MaterialXNode::add(const char* input, const char* type)
{
    pugi::xml_node child = element_.append_child("input");
    child.append_attribute("name") = input;
    child.append_attribute("type") = type;
    return child;
}

MaterialXNode& MaterialXNode::value(const char* input, const char* type, const std::string& text)
{
    add(input, type).append_attribute("value") = text.c_str();
    return *this;
}

MaterialXNode& MaterialXNode::value(const char* input, double number)
{
    return value(input, "float", digits(number));
}

MaterialXNode& MaterialXNode::value(const char* input, const spectral::Vec3& colour)
{
    return value(
        input, "color3",
        fmt::format("{}, {}, {}", digits(colour[0]), digits(colour[1]), digits(colour[2])));
}

MaterialXNode& MaterialXNode::node(const char* input, const char* type, const char* from)
{
    add(input, type).append_attribute("nodename") = from;
    return *this;
}

MaterialXNode& MaterialXNode::interface(const char* input, const char* type, const char* from)
{
    add(input, type).append_attribute("interfacename") = from;
    return *this;
}

MaterialXGraph::MaterialXGraph(pugi::xml_node document, const std::string& material,
                               const std::string& doc)
{
    const std::string name = "NG_" + material;
    graph_ = document.append_child("nodegraph");
    graph_.append_attribute("name") = name.c_str();
    graph_.append_attribute("doc") = doc.c_str();
    pugi::xml_node wears = document.append_child("surfacematerial");
    wears.append_attribute("name") = material.c_str();
    wears.append_attribute("type") = "material";
    wears.append_attribute("doc") = doc.c_str();
    pugi::xml_node shader = wears.append_child("input");
    shader.append_attribute("name") = "surfaceshader";
    shader.append_attribute("type") = "surfaceshader";
    shader.append_attribute("nodegraph") = name.c_str();
    shader.append_attribute("output") = "out";
}

void MaterialXGraph::input(const char* name, const char* label, double value, double min,
                           double max)
{
    pugi::xml_node child = graph_.append_child("input");
    child.append_attribute("name") = name;
    child.append_attribute("type") = "float";
    child.append_attribute("value") = digits(value).c_str();
    child.append_attribute("uiname") = label;
    child.append_attribute("uimin") = digits(min).c_str();
    child.append_attribute("uimax") = digits(max).c_str();
}

MaterialXNode MaterialXGraph::node(const char* category, const char* name, const char* type)
{
    pugi::xml_node child = graph_.append_child(category);
    child.append_attribute("name") = name;
    child.append_attribute("type") = type;
    return MaterialXNode(child);
}

void MaterialXGraph::arithmetic(const char* category, const char* name, const char* from,
                                double number)
{
    node(category, name, "float").node("in1", "float", from).value("in2", number);
}

void MaterialXGraph::roughness()
{
    node("roughness_anisotropy", "alpha", "vector2")
        .interface("roughness", "float", "roughness")
        .value("anisotropy", 0.0);
}

void MaterialXGraph::finish(const char* bsdf, bool thin_walled)
{
    MaterialXNode surface = node("surface", "shader", "surfaceshader");
    surface.node("bsdf", "BSDF", bsdf);
    if (thin_walled) surface.value("thin_walled", "boolean", "true");
    output("shader");
}

void MaterialXGraph::output(const char* shader)
{
    pugi::xml_node out = graph_.append_child("output");
    out.append_attribute("name") = "out";
    out.append_attribute("type") = "surfaceshader";
    out.append_attribute("nodename") = shader;
}

}  // namespace nacre::tool
