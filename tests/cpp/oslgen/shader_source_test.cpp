// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/shader_source.h"

#include <gtest/gtest.h>

#include <string>

#include "support/expect.h"

namespace nacre::oslgen {
namespace {

const std::string kShader = R"osl(// the word shader in a comment
#include "nacre/nacre_surface.h"
float helper(float a) { return a; }

shader nacre_sample
[[ string label = "Sample", string help = "one "
                                          "text; with ) and \"quotes\"" ]]
(
    float depth_nm = 110.0  // of a groove, in brackets: ([
        [[ string label = "Depth (nm)", string units = "nm", float min = 0.0, float max = 2e3 ]],
    int orders = 3
        [[ int min = 1, int max = 9 ]],
    color tint = color(0.9, 0.8, 0.7),
    float edges[NACRE_EDGES] = NACRE_LIST [[ string widget = "null" ]],
    normal surface_normal = N,
    output closure color BSDF = 0
)
{
    nacre_thing thing = { clamp(orders, 1, 9), max(depth_nm, 0.0), thing.depth_nm };
    float index = helper(depth_nm);
    BSDF = nacre_lobes(thing, surface_normal, index, edges, a_rather_long_name, another_much_longer_name, tint);
}
)osl";

TEST(ShaderSource, IsWhatTheTextDeclares)
{
    const ShaderSource shader = parse_shader(kShader, "s.osl");
    EXPECT_EQ(shader.name, "nacre_sample");
    EXPECT_EQ(shader.line, 5);
    EXPECT_EQ(shader.told("label"), "Sample");
    EXPECT_EQ(shader.told("help"), "one text; with ) and \"quotes\"");
    EXPECT_EQ(shader.told("category", "none"), "none");
    ASSERT_EQ(shader.parameters.size(), 6u);
    const ShaderParameter& depth = shader.parameters[0];
    EXPECT_EQ(depth.type, "float");
    EXPECT_EQ(depth.value, "110.0");
    EXPECT_EQ(depth.line, 9);
    EXPECT_EQ(depth.told("max"), "2e3");
    EXPECT_EQ(shader.parameters[2].value, "color(0.9, 0.8, 0.7)");
    EXPECT_EQ(shader.parameters[3].size, "NACRE_EDGES");
    EXPECT_TRUE(shader.parameters[3].is_hidden());
    EXPECT_TRUE(shader.parameters[5].is_output);
    EXPECT_EQ(shader.parameters[5].type, "closure color");
}

TEST(ShaderSource, TakesWhatAMaterialKnows)
{
    const Given given{.constants = {{"orders", "12"}, {"depth_nm", "85.5"}, {"tint", "color(1.0)"}},
                      .variables = {{"index", "nacre_index(knots, 360.0)"}}};
    EXPECT_EQ(specialised(parse_shader(kShader, "s.osl"), given),
              "    nacre_thing thing = { 9, 85.5, thing.depth_nm };\n"
              "    float index = nacre_index(knots, 360.0);\n"
              "    BSDF = nacre_lobes(thing, surface_normal, index, edges, a_rather_long_name,\n"
              "                       another_much_longer_name, color(1.0));\n");
}

TEST(ShaderSource, DropsWhatAConstantReplaces)
{
    const Given given{.constants = {{"index", "1.5"}}, .variables = {}};
    const std::string text = specialised(parse_shader(kShader, "s.osl"), given);
    EXPECT_EQ(text.find("float index"), std::string::npos);
    EXPECT_NE(text.find("surface_normal, 1.5, edges"), std::string::npos);
    EXPECT_NE(text.find("{ clamp(orders, 1, 9), max(depth_nm, 0.0),"), std::string::npos);
}

TEST(ShaderSource, SaysWhereATextIsNoShader)
{
    const auto problem = [](const std::string& text) {
        return test::input_error_of([&] { static_cast<void>(parse_shader(text, "s.osl")); });
    };
    EXPECT_EQ(problem("float f() { return 1; }\n"),
              "s.osl:2: must be a shader: shader NAME ( … ) { … }");
    EXPECT_EQ(problem("shader a\n(float b)\n{}\n"), "s.osl:2: must have = here");
    EXPECT_EQ(problem("shader a(float b = 1\n{"), "s.osl:2: ends inside a shader");
    EXPECT_EQ(problem("shader a [[ string label = \"x ]] ()\n{}\n"),
              "s.osl:1: has a string without an end");
}

TEST(ShaderSource, ShippedOnesAreFoundByName)
{
    EXPECT_EQ(shipped_shader("nacre_disc").name, "nacre_disc");
    EXPECT_INPUT_ERROR((void)shipped_shader("none"), "shaders/none.osl: there is no such shader");
}

}  // namespace
}  // namespace nacre::oslgen
