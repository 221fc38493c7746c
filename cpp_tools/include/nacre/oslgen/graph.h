// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace nacre::oslgen {

/// Collects nodes and links in the form of the manifest.
class Graph {
public:
    void node(std::string id, std::string type,
              nlohmann::json properties = nlohmann::json::object(),
              nlohmann::json values = nlohmann::json::object())
    {
        nlohmann::json entry{{"id", std::move(id)}, {"type", std::move(type)}};
        if (!properties.empty()) entry["properties"] = std::move(properties);
        if (!values.empty()) entry["values"] = std::move(values);
        nodes_.push_back(std::move(entry));
    }

    void image(const std::string& id, const std::string& table)
    {
        nodes_.push_back({{"id", id}, {"type", "ShaderNodeTexImage"}, {"table", table}});
    }

    /// Whether this is the first time that `id` is asked for.
    [[nodiscard]] bool first(const std::string& id) { return made_.insert(id).second; }

    void link(std::string from, std::string to)
    {
        links_.push_back(nlohmann::json::array({std::move(from), std::move(to)}));
    }

    [[nodiscard]] nlohmann::json json() const { return {{"nodes", nodes_}, {"links", links_}}; }

private:
    nlohmann::json nodes_ = nlohmann::json::array(), links_ = nlohmann::json::array();
    std::set<std::string> made_;
};

/// value * factor + offset
inline void multiply_add(Graph& graph, const std::string& id, const std::string& from,
                         double factor, double offset)
{
    graph.node(id, "ShaderNodeMath", {{"operation", "MULTIPLY_ADD"}},
               {{"1", factor}, {"2", offset}});
    graph.link(from, id + ".0");
}

/// Math nodes whose operands are sockets or numbers; each call returns the socket of the result.
class Calculation {
public:
    explicit Calculation(Graph& graph) : graph_(&graph) {}

    std::string number(const std::string& id, const char* operation,
                       const std::vector<nlohmann::json>& operands, bool clamped = false)
    {
        add("ShaderNodeMath", id, operation, operands, clamped);
        return id + ".Value";
    }
    std::string vector(const std::string& id, const char* operation,
                       const std::vector<nlohmann::json>& operands)
    {
        add("ShaderNodeVectorMath", id, operation, operands, false);
        return id + ".Vector";
    }

private:
    Graph* graph_;

    void add(const char* type, const std::string& id, const char* operation,
             const std::vector<nlohmann::json>& operands, bool clamped)
    {
        nlohmann::json properties{{"operation", operation}}, values = nlohmann::json::object();
        if (clamped) properties["use_clamp"] = true;
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (operands[i].is_number()) values[std::to_string(i)] = operands[i];
        graph_->node(id, type, std::move(properties), std::move(values));
        for (std::size_t i = 0; i < operands.size(); ++i)
            if (operands[i].is_string())
                graph_->link(operands[i].get<std::string>(), fmt::format("{}.{}", id, i));
    }
};

}  // namespace nacre::oslgen
