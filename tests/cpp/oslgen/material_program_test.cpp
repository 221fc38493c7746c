// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/material_program.h"

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

const std::string kHead = R"(schema = 1
[material]
id = "test"
name = "A \"Test\""
category = "Tests"
description = "one \\ two"
source = "made up"
)";

const std::string kFilm = kHead + R"([ambient]
medium = "air"
[[layer]]
n = 1.33
thickness_nm = { default = 400, min = 100, max = 1500, varies = true }
[substrate]
medium = "air"
[surface]
roughness = 0.1
transmission = true
[[parameter]]
name = "coverage"
label = "Cover"
default = 0.75
)";

TableInfo table(const std::string& name, int height)
{
    return {.name = name,
            .file = "test_" + name + ".exr",
            .quantity = "reflectance",
            .x = {"cos_theta", "1", 0.0, 1.0, 64},
            .y = {"thickness_nm", "nm", 100.0, 1500.0, height},
            .error_max = 0.09,
            .error_mean = 0.01,
            .lowest = name == "R" ? -0.25 : 0.0};
}

Context film_context(const material::MaterialTemplate& source)
{
    Context context;
    context.source = &source;
    context.tables = {table("R", 512), table("T", 512), table("R_bare", 1), table("T_bare", 1)};
    context.space = "lin_rec709_scene";
    context.illuminant = "D65";
    context.observer = "cie1931";
    return context;
}

Context glass_context(const material::MaterialTemplate& source)
{
    Context context = film_context(source);
    context.tables.clear();
    context.wavelengths = {{400.0, 500.0, 700.0}, {{-0.5, 0.0, 2.0}, {2.5, 2.0, 0.0}}};
    context.glass =
        GlassIndex{360.0, 10.0, std::vector<double>(48, 1.5), {1.5, 1.51, 1.52}, 1.52, 1.51, 1.5};
    return context;
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

TEST(MaterialProgram, FilmShaderIsSelfContained)
{
    const auto source = material::parse_template(kFilm, "test.toml");
    const auto program = generate(film_context(source));

    EXPECT_EQ(program.osl.find("#include"), std::string::npos);
    EXPECT_EQ(program.osl.find("#pragma"), std::string::npos);
    EXPECT_NE(program.osl.find("shader nacre_test"), std::string::npos);
    EXPECT_NE(program.osl.find(R"(string label = "A \"Test\"")"), std::string::npos);
    EXPECT_NE(program.osl.find(R"(string help = "one \\ two")"), std::string::npos);
    EXPECT_NE(program.osl.find("float thickness_nm = 400.0"), std::string::npos);
    EXPECT_NE(program.osl.find("string units = \"nm\", float min = 100.0, float max = 1500.0"),
              std::string::npos);
    EXPECT_NE(program.osl.find("float y = (thickness_nm - 100.0) / 1400.0;"), std::string::npos);
    EXPECT_NE(program.osl.find("T * transparent() + BSDF"), std::string::npos);
}

// ISO C, 5.2.1.1: two question marks and one of nine characters are another one; compilers warn of
// them in strings and comments alike, or take them for that.
TEST(MaterialProgram, ShaderHoldsNoTrigraphs)
{
    const std::string pair(2, '?'), odd = "Why" + pair + ") " + pair + pair + "/";
    std::string text = kFilm;
    for (const std::string word : {R"(A \"Test\")", R"(one \\ two)", "Cover"})
        text.replace(text.find(word), word.size(), odd);
    const auto source = material::parse_template(text, "test.toml");
    const auto program = generate(film_context(source));

    EXPECT_EQ(program.osl.find(pair), std::string::npos);
    for (const std::string key : {"label", "help"})
        EXPECT_NE(program.osl.find("string " + key + R"( = "Why?" "?) ?" "?" "?" "?/")"),
                  std::string::npos);
    EXPECT_NE(program.osl.find("// Why? ?) ? ? ? ?/. Made by"), std::string::npos);
    EXPECT_EQ(Json::parse(program.manifest)["name"], odd);
}

TEST(MaterialProgram, SocketsAreInTheOrderOfTheManifestAndTakeTheTemplatesWords)
{
    const auto source = material::parse_template(kFilm, "test.toml");
    const auto result = sockets(film_context(source));

    ASSERT_EQ(result.size(), 4u);
    EXPECT_EQ(result[0].name, "thickness_nm");
    EXPECT_DOUBLE_EQ(result[0].min, 100.0);
    EXPECT_EQ(result[1].name, "coverage");
    EXPECT_EQ(result[1].label, "Cover");
    EXPECT_DOUBLE_EQ(result[1].value, 0.75);
    EXPECT_EQ(result[2].name, "roughness");
    EXPECT_DOUBLE_EQ(result[2].value, 0.1);
    EXPECT_EQ(result[3].type, "normal");
}

TEST(MaterialProgram, ManifestHoldsWhatTheExtensionNeeds)
{
    const auto source = material::parse_template(kFilm, "test.toml");
    const Json manifest = Json::parse(generate(film_context(source)).manifest);

    EXPECT_EQ(manifest["kind"], "film");
    EXPECT_EQ(manifest["wavelength_per_path"], false);
    EXPECT_EQ(manifest["template_sha256"], source.sha256);
    EXPECT_EQ(manifest["gamut"], (Json{{"negative", true}, {"lowest", -0.25}}));
    EXPECT_EQ(manifest["sockets"][0]["label"], "Film Thickness (nm)");
    EXPECT_EQ(manifest["tables"].size(), 4u);
    EXPECT_EQ(manifest["tables"][0]["axes"][1]["max"], 1500.0);
    expect_sound(manifest, manifest["graphs"]["osl"]);
    expect_sound(manifest, manifest["graphs"]["nodes"]);
}

/// The two multiply-adds must put the ends of the axis on the centres of the edge texels.
TEST(MaterialProgram, GraphMapsAxesToTexelCentres)
{
    const auto source = material::parse_template(kFilm, "test.toml");
    const Json manifest = Json::parse(generate(film_context(source)).manifest);
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

TEST(MaterialProgram, GlassCarriesItsWavelengthsAndLines)
{
    const auto source = material::parse_template(kHead + "[glass]\nn = 1.5\n", "test.toml");
    const auto program = generate(glass_context(source));
    const Json manifest = Json::parse(program.manifest);

    EXPECT_NE(program.osl.find("float wavelength_edges[3] = {\n        400.0, 500.0, 700.0 }"),
              std::string::npos);
    EXPECT_NE(program.osl.find("color(-0.5, 0.0, 2.0)"), std::string::npos);
    EXPECT_EQ(manifest["kind"], "glass");
    EXPECT_EQ(manifest["wavelength_per_path"], true);
    EXPECT_EQ(manifest["glass"]["lines"]["F"], 1.52);
    EXPECT_EQ(manifest["graphs"]["nodes"]["nodes"][0]["values"]["IOR"], 1.51);
    expect_sound(manifest, manifest["graphs"]["osl"]);
    expect_sound(manifest, manifest["graphs"]["nodes"]);
}

TEST(MaterialProgram, GratingHasNoFormWithoutOsl)
{
    const auto source = material::parse_template(kHead + R"([grating]
pitch_nm = 1600
depth_nm = 110
profile = "sinusoidal"
cover = { n = 1.58 }
substrate = { n = 0.9, k = 6 }
)",
                                                 "test.toml");
    Context context = glass_context(source);
    context.glass.reset();
    context.grating = GratingColours{
        .tint = {0.8, 0.85, 0.9}, .basis = {{0.9, 0.1, 0.0}, {0.0, 0.2, 0.8}}, .cover_index = 1.58};
    const auto program = generate(context);
    const Json manifest = Json::parse(program.manifest);

    EXPECT_EQ(manifest["kind"], "grating");
    EXPECT_TRUE(manifest["graphs"]["nodes"].is_null());
    EXPECT_EQ(manifest["grating"]["pitch_nm"], 1600.0);
    EXPECT_EQ(manifest["sockets"][1]["default"], (Json{0.8, 0.85, 0.9}));
    EXPECT_NE(program.osl.find("{ 0, max(pitch_nm, 100.0), 110.0, 0.5, 1.58, 3,"),
              std::string::npos);
    EXPECT_NE(program.osl.find(
                  "color tint_basis[2] = {\n        color(0.9, 0.1, 0.0), color(0.0, 0.2, 0.8) }"),
              std::string::npos);
    expect_sound(manifest, manifest["graphs"]["osl"]);
}

TEST(MaterialProgram, EqualInputGivesEqualBytes)
{
    const auto source = material::parse_template(kFilm, "test.toml");
    const auto first = generate(film_context(source)), second = generate(film_context(source));
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
