// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <pugixml.hpp>

#include "nacre/spectral/colour.h"

/// @file
/// Elements of a MaterialX 1.39 document.

namespace nacre::tool {

/// One node of a graph; each call adds an input.
class MaterialXNode {
public:
    explicit MaterialXNode(pugi::xml_node element) : element_(element) {}

    MaterialXNode& value(const char* input, const char* type, const std::string& text);
    MaterialXNode& value(const char* input, double number);
    MaterialXNode& value(const char* input, const spectral::Vec3& colour);
    /// From the output of another node of the graph.
    MaterialXNode& node(const char* input, const char* type, const char* from);
    /// From an input of the graph itself.
    MaterialXNode& interface(const char* input, const char* type, const char* from);

    [[nodiscard]] pugi::xml_node element() const { return element_; }

private:
    pugi::xml_node element_;

    pugi::xml_node add(const char* input, const char* type);
};

/// A node graph whose output is a surface shader, and the material that wears it.
class MaterialXGraph {
public:
    /// @param doc  what the material is and how exact, for people
    MaterialXGraph(pugi::xml_node document, const std::string& material, const std::string& doc);

    /// An input of the graph, as artists see it.
    void input(const char* name, const char* label, double value, double min, double max);
    [[nodiscard]] MaterialXNode node(const char* category, const char* name, const char* type);
    /// A node of two floats, the second a number.
    void arithmetic(const char* category, const char* name, const char* from, double number);
    /// Alpha of both axes from the input `roughness`: α = roughness², as Principled has it.
    void roughness();
    /// Ends the graph with a surface of this BSDF.
    void finish(const char* bsdf, bool thin_walled);
    /// Ends the graph with a node that is a surface shader already.
    void output(const char* shader);

private:
    pugi::xml_node graph_;
};

}  // namespace nacre::tool
