// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/write.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "nacre/core/diagnostics.h"

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

TableInfo table(const TableRole& role, int height)
{
    return {.role = role,
            .file = "test_" + table_name(role) + ".exr",
            .quantity = "reflectance",
            .x = {"cos_theta", "1", 0.0, 1.0, 64},
            .y = {"thickness_nm", "nm", 100.0, 1500.0, height},
            .error_max = 0.09,
            .error_mean = 0.01,
            .lowest = role == TableRole{TableOf::R} ? -0.25 : 0.0};
}

Socket slider(const std::string& name, double value, double min, double max)
{
    return {.name = name,
            .label = name + " (nm)",
            .type = "float",
            .unit = "nm",
            .description = "about " + name,
            .value = value,
            .min = min,
            .max = max};
}

/// A program without a body.
Program headed()
{
    Program program;
    program.head.id = "test";
    program.head.name = R"(A "Test")";
    program.head.description = R"(one \ two)";
    program.head.sha256 = "abc";
    program.kind = "sort";
    program.colours = {.space = "lin_rec709_scene",
                       .illuminant = "D65",
                       .observer = "cie1931",
                       .adaptation = "bradford"};
    return program;
}

Program surface_program()
{
    Program program = headed();
    program.sockets = {slider("thickness_nm", 400.0, 100.0, 1500.0), slider("coverage", 1, 0, 1),
                       slider("roughness", 0, 0, 1), normal_socket()};
    program.body = TableSurface{.tables = {table({TableOf::R}, 512), table({TableOf::T}, 512),
                                           table({TableOf::R, TableContent::smooth, true}, 1),
                                           table({TableOf::T, TableContent::smooth, true}, 1)},
                                .below = ThinWall{},
                                .fades = true};
    return program;
}

Program shader_program()
{
    Program program = headed();
    program.sockets = {normal_socket()};
    program.traits.wavelength_per_path = true;
    program.traits.truth = Truth::white;
    program.constants = {{.declaration = "float edges[3]",
                          .value = "{ 400.0, 500.0, 700.0 }",
                          .label = "Edges",
                          .help = "of cells"}};
    program.body = ShaderBody{.includes = {"nacre/nacre_table.h"},
                              .statements = "    BSDF = diffuse(surface_normal);\n",
                              .nodes = "there are none"};
    program.more["sort"] = 7;
    return program;
}

/// Every link joins nodes that exist, or the group's own sockets.
void expect_sound(const Json& manifest, const Json& graph)
{
    std::set<std::string> ids{"input", "output"};
    for (const Json& node : graph["nodes"]) EXPECT_TRUE(ids.insert(node["id"]).second) << node;
    std::set<std::string> socket_names;
    for (const Json& socket : manifest["sockets"]) socket_names.insert(socket["name"]);
    std::set<std::string> targets;
    for (const Json& link : graph["links"]) {
        const auto from = link[0].get<std::string>(), to = link[1].get<std::string>();
        EXPECT_TRUE(ids.contains(from.substr(0, from.find('.')))) << from;
        EXPECT_TRUE(ids.contains(to.substr(0, to.find('.')))) << to;
        EXPECT_TRUE(targets.insert(to).second) << "two links into " << to;
        const bool is_input = from.starts_with("input.");
        EXPECT_TRUE(!is_input || socket_names.contains(from.substr(6))) << from;
    }
    EXPECT_TRUE(targets.contains("output.BSDF"));
}

TEST(Write, ShaderIsSelfContained)
{
    const auto text = write(surface_program());

    EXPECT_EQ(text.osl.find("#include"), std::string::npos);
    EXPECT_EQ(text.osl.find("#pragma"), std::string::npos);
    EXPECT_NE(text.osl.find("shader nacre_test"), std::string::npos);
    EXPECT_NE(text.osl.find(R"(string label = "A \"Test\"")"), std::string::npos);
    EXPECT_NE(text.osl.find(R"(string help = "one \\ two")"), std::string::npos);
    EXPECT_NE(text.osl.find("float thickness_nm = 400.0"), std::string::npos);
    EXPECT_NE(text.osl.find("string units = \"nm\", float min = 100.0, float max = 1500.0"),
              std::string::npos);
    EXPECT_NE(text.osl.find("float y = (thickness_nm - 100.0) / 1400.0;"), std::string::npos);
    EXPECT_NE(text.osl.find("T * transparent() + BSDF"), std::string::npos);
}

// ISO C, 5.2.1.1: two question marks and one of nine characters are another one; compilers warn of
// them in strings and comments alike, or take them for that.
TEST(Write, ShaderHoldsNoTrigraphs)
{
    const std::string pair(2, '?'), odd = "Why" + pair + ") " + pair + pair + "/";
    Program program = surface_program();
    program.head.name = program.head.description = program.sockets[1].label = odd;
    const auto text = write(program);

    EXPECT_EQ(text.osl.find(pair), std::string::npos);
    for (const std::string key : {"label", "help"})
        EXPECT_NE(text.osl.find("string " + key + R"( = "Why?" "?) ?" "?" "?" "?/")"),
                  std::string::npos);
    EXPECT_NE(text.osl.find("// Why? ?) ? ? ? ?/. Made by"), std::string::npos);
    EXPECT_EQ(Json::parse(text.manifest)["name"], odd);
}

TEST(Write, ManifestHoldsWhatTheExtensionNeeds)
{
    const Json manifest = Json::parse(write(surface_program()).manifest);

    EXPECT_EQ(manifest["kind"], "sort");
    EXPECT_EQ(manifest["wavelength_per_path"], false);
    EXPECT_EQ(manifest["template_sha256"], "abc");
    EXPECT_EQ(manifest["gamut"], (Json{{"negative", true}, {"lowest", -0.25}}));
    EXPECT_EQ(manifest["sockets"][0]["label"], "thickness_nm (nm)");
    EXPECT_EQ(manifest["tables"].size(), 4u);
    EXPECT_EQ(manifest["tables"][0]["axes"][1]["max"], 1500.0);
    EXPECT_EQ(manifest["tables"][3]["role"],
              (Json{{"of", "T"}, {"content", "smooth"}, {"bare", true}}));
    expect_sound(manifest, manifest["graphs"]["osl"]);
    expect_sound(manifest, manifest["graphs"]["nodes"]);
}

TEST(Write, ManifestHasTheTraits)
{
    Program program = shader_program();
    EXPECT_EQ(Json::parse(write(program).manifest)["traits"],
              Json::parse(R"({"stage": "shaderball", "editable_stack": false, "probe": false,
                              "closures": [{"output": "BSDF", "role": "surface"}],
                              "truth": "white", "furnace": "surface"})"));
    program.traits = {.stage = "prism",
                      .editable_stack = true,
                      .probe = true,
                      .closures = {{"Light", ClosureRole::emission}, {"Fog", ClosureRole::volume}},
                      .is_body = true};
    EXPECT_EQ(Json::parse(write(program).manifest)["traits"],
              Json::parse(R"({"stage": "prism", "editable_stack": true, "probe": true,
                              "closures": [{"output": "Light", "role": "emission"},
                                           {"output": "Fog", "role": "volume"}],
                              "truth": null, "furnace": "body"})"));
}

/// The two multiply-adds must put the ends of the axis on the centres of the edge texels.
TEST(Write, GraphMapsAxesToTexelCentres)
{
    const Json manifest = Json::parse(write(surface_program()).manifest);
    const auto mapped = [&](const std::string& id, double x) {
        for (const Json& node : manifest["graphs"]["nodes"]["nodes"])
            if (node["id"] == id)
                return x * node["values"]["1"].get<double>() + node["values"]["2"].get<double>();
        ADD_FAILURE() << "no node " << id;
        return 0.0;
    };
    EXPECT_DOUBLE_EQ(mapped("at_64x512_u", 0.0), 0.5 / 64);
    EXPECT_DOUBLE_EQ(mapped("at_64x512_u", 1.0), 63.5 / 64);
    // Row 0, the top of the image, is the minimum; v = 0 is the bottom.
    EXPECT_NEAR(mapped("row_of_512", 100.0), 511.5 / 512, 1e-15);
    EXPECT_NEAR(mapped("row_of_512", 1500.0), 0.5 / 512, 1e-15);
}

TEST(Write, ShaderOfItsOwnHasItsConstants)
{
    const auto text = write(shader_program());
    const Json manifest = Json::parse(text.manifest);

    EXPECT_NE(text.osl.find("float edges[3] = { 400.0, 500.0, 700.0 }"), std::string::npos);
    EXPECT_NE(text.osl.find("    BSDF = diffuse(surface_normal);\n}\n"), std::string::npos);
    EXPECT_EQ(manifest["wavelength_per_path"], true);
    EXPECT_EQ(manifest["sort"], 7);
    EXPECT_TRUE(manifest["graphs"]["nodes"].is_null());
    expect_sound(manifest, manifest["graphs"]["osl"]);
}

TEST(Write, EqualInputGivesEqualBytes)
{
    const auto first = write(surface_program()), second = write(surface_program());
    EXPECT_EQ(first.osl, second.osl);
    EXPECT_EQ(first.manifest, second.manifest);
    EXPECT_EQ(first.manifest.back(), '\n');
}

TEST(InlineIncludes, PutsEachHeaderInOnce)
{
    const std::string osl = inline_includes(
        "#include \"nacre/nacre_film.h\"\n#include \"nacre/nacre_complex.h\"\nshader s() {}\n",
        "s.osl");
    std::size_t count = 0;
    for (std::size_t at = osl.find("struct nacre_complex"); at != std::string::npos;
         at = osl.find("struct nacre_complex", at + 1))
        ++count;
    EXPECT_EQ(count, 1u);
    EXPECT_LT(osl.find("nacre_forward_q"), osl.find("nacre_airy"));
}

TEST(InlineIncludes, NamesAHeaderThatIsMissing)
{
    try {
        static_cast<void>(inline_includes("\n#include \"nacre/none.h\"\n", "s.osl"));
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics()[0].text(), "s.osl:2: no such header: nacre/none.h");
    }
}

}  // namespace
}  // namespace nacre::oslgen
