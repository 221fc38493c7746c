// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "nacre/core/diagnostics.h"
#include "nacre/kinds/kind.h"
#include "nacre/kinds/read_template.h"
#include "nacre/oslgen/write.h"

namespace nacre::kinds {
namespace {

using Json = nlohmann::json;

const std::string kWormHead = R"(// SPDX-FileCopyrightText: Somebody
// SPDX-License-Identifier: MIT
#include "nacre/nacre_colour_tables.h"
#include "nacre/nacre_view.h"

surface glow
[[ string label = "Glow", string help = "A glowing " "worm", string category = "Mine/Worms",
   string source = "made up", string tags = "worm, light", string stage = "sphere",
   string presets = "Dim: power = 0.5; Bright: power = 4, steps = 3" ]]
)";

const std::string kInputs = R"(
    float power = 1.0 [[ string label = "Power in W", string units = "W", string help = "How bright",
                         float min = 0.0, float max = 10.0 ]],
    int steps = 2 [[ int min = 1, int max = 5 ]],
    color tint = color(1.0, 0.5, 0.25),
    color grey = 0.5,
    normal surface_normal = N,
    vector tangent = vector(0.0),
    vector place = P,
    string picture = "",
    float curve[3] = { 0.0, 0.5, 1.0 },
    float hidden = M_PI [[ string widget = "null" ]],
)";

const std::string kBody = R"({
    Emission = power * tint * max(0.0, dot(surface_normal, NACRE_TO_VIEWER)) * emission();
    BSDF = diffuse(surface_normal);
}
)";

std::string worm(const std::string& head = kWormHead, const std::string& inputs = kInputs,
                 const std::string& more = "")
{
    return head + "(" + inputs + R"(    output closure color BSDF = 0,
    output closure color Emission = 0 [[ string role = "emission" ]],
    output float told = 0
)
)" + kBody +
           more;
}

oslgen::ProgramText written(const std::string& osl)
{
    const MaterialTemplate source = parse_template(osl, "worm.osl");
    oslgen::Program program = source.kind->prepare(source, {}).program;
    program.head = source;
    program.kind = source.kind->name();
    program.traits = source.kind->traits();
    return oslgen::write(program);
}

Json manifest_of(const std::string& osl)
{
    return Json::parse(written(osl).manifest);
}

std::vector<std::string> problems_of(const std::string& osl)
{
    std::vector<std::string> result;
    try {
        static_cast<void>(parse_template(osl, "worm.osl"));
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics())
            result.push_back(diagnostic.text());
    }
    return result;
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(HandWritten, MetadataSayWhatTheHeadOfATemplateDoes)
{
    const MaterialTemplate source = parse_template(worm(), "worm.osl");
    EXPECT_EQ(source.kind->name(), "shader");
    EXPECT_EQ(source.id, "glow");
    EXPECT_EQ(source.name, "Glow");
    EXPECT_EQ(source.description, "A glowing worm");
    EXPECT_EQ(source.category, "Mine/Worms");
    EXPECT_EQ(source.tags, (std::vector<std::string>{"worm", "light"}));
    EXPECT_EQ(source.status, material::Status::typical);
    EXPECT_EQ(source.text, worm());
    EXPECT_EQ(source.kind->traits().stage, "sphere");
    EXPECT_FALSE(source.kind->traits().wavelength_per_path);
    EXPECT_TRUE(source.kind->media().empty());
    EXPECT_EQ(source.kind->driven_socket(), "");
}

TEST(HandWritten, ParametersThatGroupsCanHaveAreInputs)
{
    const Json sockets = manifest_of(worm())["sockets"];
    std::vector<std::string> names;
    for (const Json& socket : sockets) names.push_back(socket["name"]);
    EXPECT_EQ(names,
              (std::vector<std::string>{"power", "steps", "tint", "grey", "normal", "tangent"}));
    EXPECT_EQ(sockets[0], Json::parse(R"({"name": "power", "label": "Power in W", "type": "float",
        "unit": "W", "description": "How bright", "default": 1.0, "min": 0.0, "max": 10.0})"));
    EXPECT_EQ(sockets[1]["default"], 2);
    EXPECT_EQ(sockets[1]["label"], "steps");
    EXPECT_EQ(sockets[2]["default"], (std::vector<double>{1.0, 0.5, 0.25}));
    EXPECT_EQ(sockets[3]["default"], (std::vector<double>{0.5, 0.5, 0.5}));
}

TEST(HandWritten, EveryClosureIsAnOutputOfItsRole)
{
    const Json written = manifest_of(worm());
    EXPECT_EQ(written["traits"]["closures"], Json::parse(R"([
        {"output": "BSDF", "role": "surface"}, {"output": "Emission", "role": "emission"}])"));
    const Json links = written["graphs"]["osl"]["links"];
    EXPECT_NE(std::ranges::find(links, Json{"script.Emission", "output.Emission"}), links.end());
    EXPECT_NE(std::ranges::find(links, Json{"input.normal", "script.surface_normal"}), links.end());
    EXPECT_TRUE(written["graphs"]["nodes"].is_null());
}

TEST(HandWritten, PresetsAreValuesOfInputs)
{
    EXPECT_EQ(manifest_of(worm())["presets"], Json::parse(R"([
        {"name": "Dim", "values": {"power": 0.5}},
        {"name": "Bright", "values": {"power": 4.0, "steps": 3}}])"));
}

TEST(HandWritten, TheTextStaysButForIncludesAndTheViewer)
{
    const std::string osl = written(worm()).osl;
    EXPECT_NE(osl.find("// SPDX-FileCopyrightText: Somebody\n"), std::string::npos);
    EXPECT_NE(osl.find("// SPDX-License-Identifier: MIT\n"), std::string::npos);
    EXPECT_NE(osl.find("dot(surface_normal, I))"), std::string::npos);
    EXPECT_EQ(osl.find("#include"), std::string::npos);
    EXPECT_EQ(osl.find("nacre_view"), std::string::npos);
}

TEST(HandWritten, ColourTablesAreThoseOfTheOptions)
{
    const MaterialTemplate source = parse_template(worm(), "worm.osl");
    const auto text = [&](const CompileOptions& options) {
        return std::get<oslgen::ShaderText>(source.kind->prepare(source, options).program.body)
            .text;
    };
    CompileOptions wide;
    wide.space = "lin_rec2020_scene";
    EXPECT_NE(text({}).find("Colours are lin_rec709_scene, D65, cie1931."), std::string::npos);
    EXPECT_NE(text(wide).find("Colours are lin_rec2020_scene, D65, cie1931."), std::string::npos);
}

TEST(HandWritten, LinesMayEndAsOnWindows)
{
    std::string osl;
    for (const char c : worm()) osl += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(written(osl).osl, written(worm()).osl);
}

TEST(HandWritten, WhoDrawsForThePathHasAWavelengthOfItsOwn)
{
    const auto drawn = worm(kWormHead, kInputs, "// nacre_path_random\n");
    EXPECT_TRUE(parse_template(drawn, "worm.osl").kind->traits().wavelength_per_path);
}

const std::string kNodes = R"(/* nodes
{ "nodes": [{ "id": "glow", "type": "ShaderNodeEmission" }, { "id": "matt", "type": "ShaderNodeBsdfDiffuse" }],
  "links": [["input.tint", "glow.Color"], ["glow.Emission", "output.Emission"], ["matt.BSDF", "output.BSDF"]] }
*/
)";

TEST(HandWritten, ACommentHasItsFormInNodes)
{
    const auto text = written(worm(kWormHead, kInputs, kNodes));
    const Json nodes = Json::parse(text.manifest)["graphs"]["nodes"];
    EXPECT_EQ(nodes["nodes"].size(), 2U);
    EXPECT_EQ(nodes["links"].size(), 3U);
    EXPECT_EQ(text.osl.find("/* nodes"), std::string::npos);
}

TEST(HandWritten, AnotherHasThatWhereBandsAreRendered)
{
    const auto bands = replaced(kNodes, "/* nodes", "/* bands");
    const auto text = written(worm(kWormHead, kInputs, kNodes + bands));
    const Json graphs = Json::parse(text.manifest)["graphs"];
    EXPECT_EQ(graphs["bands"], graphs["nodes"]);
    EXPECT_EQ(text.osl.find("/* nodes"), std::string::npos);
    EXPECT_EQ(text.osl.find("/* bands"), std::string::npos);
    EXPECT_FALSE(Json::parse(written(worm(kWormHead, kInputs, kNodes)).manifest)["graphs"].contains(
        "bands"));
    const auto problems =
        problems_of(worm(kWormHead, kInputs, replaced(bands, "input.tint", "input.tin")));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].find("worm.osl:30: bands: a link must come from"), 0U) << problems[0];
}

TEST(HandWritten, AGraphThatDoesNotFitIsRefusedWithItsLine)
{
    const auto with = [](const std::string& from, const std::string& to) {
        return problems_of(worm(kWormHead, kInputs, replaced(kNodes, from, to)));
    };
    const std::string at = "worm.osl:30: nodes: ";
    EXPECT_EQ(with("input.tint", "input.hue"),
              std::vector{at + "a link must come from a node or from an input: input.grey, "
                               "input.normal, input.power, input.steps, input.tangent, input.tint "
                               "(got \"input.hue\")"});
    EXPECT_EQ(with("output.BSDF", "output.Volume"),
              (std::vector{at + "a link must lead to a node, or once to an output (got "
                                "\"output.Volume\")",
                           at + "must have a link to output.BSDF"}));
    EXPECT_EQ(with("\"matt\"", "\"glow\"").front(), at + "two nodes have the id \"glow\"");
    EXPECT_EQ(with("\"links\"", "\"lines\""),
              std::vector{at + "must be {\"nodes\": [ … ], \"links\": [ … ]}"});
    EXPECT_EQ(
        with("\"type\": \"ShaderNodeEmission\"", "\"type\": "),
        std::vector<std::string>{"worm.osl:31: nodes: must be the graph of a node group, as JSON"});
}

TEST(HandWritten, EveryProblemIsToldAtOnceWithItsLine)
{
    std::string osl = worm();
    osl = replaced(osl, "string category = \"Mine/Worms\",", "string status = \"guessed\",");
    osl = replaced(osl, "power = 0.5;", "power = 50, colour = 1;");
    osl = replaced(osl, "float power = 1.0", "float power = M_PI");
    osl = replaced(osl, "int steps = 2", "int steps = 9");
    osl = replaced(osl, "color grey = 0.5", "color grey = color(u, v, 0)");
    osl = replaced(osl, "\"emission\"", "\"light\"");
    EXPECT_EQ(
        problems_of(osl),
        (std::vector<std::string>{
            "worm.osl:23: Emission.role: must be one of surface, emission, volume (got \"light\")",
            "worm.osl:11: power: default must be a number, or the parameter hidden: [[ string "
            "widget = \"null\" ]] (got M_PI)",
            "worm.osl:13: steps: default must be in [1, 5] (got 9)",
            "worm.osl:15: grey: default must be a colour of numbers, or the parameter hidden: [[ "
            "string widget = \"null\" ]] (got color(u, v, 0))",
            "worm.osl:6: presets: \"Dim\": power must be a number in [0, 10] (got 50)",
            "worm.osl:6: presets: \"Dim\": must be of inputs that are numbers (got colour)",
            "worm.osl:6: category: is missing: [[ string category = \"…\" ]], path in the asset "
            "catalogue",
            "worm.osl:6: status: must be one of typical, sourced, measured (got \"guessed\")"}));
}

TEST(HandWritten, HeadersOfOthersAreRefused)
{
    const std::string rule =
        "must be a header of Nacre's, nacre/…, as a material is one file; put "
        "others in place (got \"";
    EXPECT_EQ(problems_of(replaced(worm(), "nacre/nacre_view.h", "mine.h")),
              std::vector{"worm.osl:4: include: " + rule + "mine.h\")"});
    EXPECT_EQ(problems_of(replaced(worm(), "nacre/nacre_view.h", "nacre/nacre_views.h")),
              std::vector{"worm.osl:4: include: " + rule + "nacre/nacre_views.h\")"});
}

TEST(HandWritten, WhatIsNoMaterialIsRefused)
{
    EXPECT_EQ(problems_of(replaced(worm(), "surface_normal = N", "bump = N")),
              std::vector<std::string>{"worm.osl:16: bump: must be called surface_normal: bump and "
                                       "normal maps go there"});
    EXPECT_EQ(problems_of(replaced(worm(), "surface glow", "surface Glow")).front(),
              "worm.osl:6: shader: must be a to z, 0 to 9 and _, start with a letter and be at "
              "most 63 characters long (got \"Glow\")");
    const std::string plain =
        "shader plain\n[[ string label = \"P\", string category = \"C\", "
        "string source = \"S\" ]]\n(float a = 1)\n{\n}\n";
    EXPECT_EQ(problems_of(plain),
              std::vector<std::string>{"worm.osl:1: plain: must have an output closure color"});
}

}  // namespace
}  // namespace nacre::kinds
