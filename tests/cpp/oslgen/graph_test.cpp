// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/graph.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

TEST(Graph, HasTheFormOfTheManifest)
{
    Graph graph;
    graph.node("a", "ShaderNodeMath", {{"operation", "ADD"}});
    graph.image("R", "R");
    graph.link("a.Value", "R.Vector");
    EXPECT_EQ(graph.json(), Json::parse(R"({
        "nodes": [{"id": "a", "type": "ShaderNodeMath", "properties": {"operation": "ADD"}},
                  {"id": "R", "type": "ShaderNodeTexImage", "table": "R"}],
        "links": [["a.Value", "R.Vector"]]})"));
}

TEST(Graph, MakesANodeOnce)
{
    Graph graph;
    EXPECT_TRUE(graph.first("a"));
    EXPECT_FALSE(graph.first("a"));
    EXPECT_TRUE(graph.first("b"));
}

TEST(Calculation, LinksSocketsAndSetsNumbers)
{
    Graph graph;
    Calculation calculate(graph);
    EXPECT_EQ(calculate.number("sum", "ADD", {"input.a", 2.0}, true), "sum.Value");
    EXPECT_EQ(calculate.vector("cross", "CROSS_PRODUCT", {"input.b", "input.c"}), "cross.Vector");
    const Json made = graph.json();
    EXPECT_EQ(made["nodes"][0]["values"], (Json{{"1", 2.0}}));
    EXPECT_EQ(made["nodes"][0]["properties"], (Json{{"operation", "ADD"}, {"use_clamp", true}}));
    EXPECT_EQ(
        made["links"],
        Json::parse(R"([["input.a", "sum.0"], ["input.b", "cross.0"], ["input.c", "cross.1"]])"));
}

}  // namespace
}  // namespace nacre::oslgen
