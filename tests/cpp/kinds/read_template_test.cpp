// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/read_template.h"

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "glass/glass.h"
#include "grating/grating.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/limits.h"
#include "nacre/core/resources.h"
#include "nacre/kinds/film.h"
#include "support/expect.h"

namespace nacre::kinds {
namespace {

using material::AbbeMedium, material::CauchyMedium, material::ConstantMedium, material::LookSpec,
    material::SellmeierMedium, material::Status;

const std::string kHead = R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
)";

const std::string kFilm = kHead + R"([ambient]
medium = "air"
[substrate]
n = 1.5
)";

/// All problems as one text, a line each.
std::string problems(const std::string& toml)
{
    try {
        static_cast<void>(parse_template(toml, "t.toml"));
    } catch (const InputError& error) {
        std::string result;
        for (const Diagnostic& problem : error.diagnostics()) result += problem.text() + '\n';
        return result;
    }
    return "";
}

TEST(Template, ReadsAFilm)
{
    const auto result = parse_template(kFilm + R"([[layer]]
cauchy = [2.2, 0.032]
thickness_nm = { default = 180, min = 0, max = 260, varies = true }
[surface]
roughness = 0.2
[[parameter]]
name = "coverage"
label = "Coverage"
default = 0.75
)",
                                       "t.toml");

    EXPECT_EQ(result.id, "test");
    EXPECT_DOUBLE_EQ(result.roughness, 0.2);
    const Film& stack = film_of(result);
    ASSERT_EQ(stack.layers.size(), 1u);
    EXPECT_EQ(std::get<CauchyMedium>(stack.layers[0].medium.value),
              (CauchyMedium{{2.2, 0.032}, 0.0}));
    EXPECT_EQ(stack.layers[0].medium.line, 12);
    EXPECT_EQ(stack.layers[0].medium.field, "layer[0].cauchy");
    EXPECT_EQ(stack.varying_layer(), 0u);
    EXPECT_DOUBLE_EQ(*stack.layers[0].thickness_nm.max, 260.0);
    EXPECT_EQ(std::get<ConstantMedium>(stack.substrate.value), (ConstantMedium{1.5, 0.0}));
    ASSERT_NE(result.parameter("coverage"), nullptr);
    EXPECT_DOUBLE_EQ(result.parameter("coverage")->value, 0.75);
}

TEST(Template, KnowsHowFarItCanBeTrusted)
{
    const std::string rest = kFilm.substr(kHead.size());
    const auto plain = parse_template(kFilm, "t.toml");
    EXPECT_EQ(plain.status, Status::typical);
    EXPECT_TRUE(plain.tags.empty());
    EXPECT_EQ(plain.text, kFilm);

    const auto told = parse_template(
        kHead + "status = \"measured\"\ntags = [\"wing\", \"blue\"]\n" + rest, "t.toml");
    EXPECT_EQ(status_name(told.status), "measured");
    EXPECT_EQ(told.tags, (std::vector<std::string>{"wing", "blue"}));

    EXPECT_EQ(problems(kHead + "status = \"true\"\ntags = [1]\n" + rest),
              "t.toml:7: material.status: must be one of measured, sourced, typical (got "
              "\"true\")\nt.toml:8: material.tags: must be strings that are not empty\n");
}

TEST(Template, CarriesALook)
{
    const std::string film =
        kFilm +
        "[[layer]]\nn = 2\nthickness_nm = { default = 9, min = 0, max = 99, varies = true }\n";
    EXPECT_EQ(parse_template(film, "t.toml").look, LookSpec{});
    const auto worn = parse_template(film +
                                         "[look]\nobject = \"blade\"\nthickness = "
                                         "[\"drop:base_nm=50,centre=0.3:0.6\", \"swirl\"]\n",
                                     "t.toml");
    EXPECT_EQ(worn.look.object, "blade");
    EXPECT_EQ(worn.look.thickness,
              (std::vector<std::string>{"drop:base_nm=50,centre=0.3:0.6", "swirl"}));

    for (const auto* wrong : {"", ":", "drop:", "drop:base_nm", "drop:base_nm=", "drop:=1", "Drop",
                              "drop:base_nm=1,", "drop:base_nm=1,,height_nm=2", "a b"})
        EXPECT_THROW(static_cast<void>(parse_template(
                         film + "[look]\nthickness = [\"" + wrong + "\"]\n", "t.toml")),
                     InputError)
            << wrong;
    EXPECT_NE(problems(film + "[look]\nobject = \"a blade\"\n")
                  .find("look.object: must be a word of a to z, 0 to 9 and _ (got \"a blade\")"),
              std::string::npos);
    EXPECT_NE(problems(kHead + "[glass]\nn = 1.5\n[look]\nthickness = [\"swirl\"]\n")
                  .find("look.thickness: needs a film whose thickness varies, or has a scale"),
              std::string::npos);
}

TEST(Template, KnowsWhatLiesBelowTheFilm)
{
    const auto interior = [](const std::string& substrate, const std::string& surface) {
        const std::string text =
            kHead + "[ambient]\nn = 1\n[substrate]\n" + substrate + "\n[surface]\n" + surface;
        return film_of(parse_template(text, "t.toml")).interior();
    };
    EXPECT_EQ(interior("n = 1.5", ""), Interior::opaque);
    EXPECT_EQ(interior("n = 1", "transmission = true"), Interior::thin_wall);
    EXPECT_EQ(interior("n = 1.5", "transmission = true"), Interior::solid);
    EXPECT_EQ(interior("n = 1.5", "diffuse_base = [0.1, 0.2, 0.3]"), Interior::diffuse);
}

TEST(Template, UnrollsGroups)
{
    const auto result = parse_template(kFilm + R"([[layer]]
repeat = 3
group = [{ n = 2.4, thickness_nm = 57 }, { n = 1.46, thickness_nm = 94 }]
[[layer]]
n = 2.4
thickness_nm = 57
[stack]
scale = { default = 1.0, min = 0.8, max = 1.2 }
)",
                                       "t.toml");

    const Film& stack = film_of(result);
    ASSERT_EQ(stack.layers.size(), 7u);
    EXPECT_DOUBLE_EQ(stack.layers[5].thickness_nm.value, 94.0);
    EXPECT_DOUBLE_EQ(stack.layers[6].thickness_nm.value, 57.0);
    EXPECT_DOUBLE_EQ(*stack.scale->max, 1.2);
    EXPECT_FALSE(stack.varying_layer().has_value());
}

TEST(Template, ReadsTheTechnique)
{
    const auto technique = [](const std::string& stack) {
        const std::string text = kFilm + "[[layer]]\nn = 1.3\nthickness_nm = 5\n" + stack;
        return film_of(parse_template(text, "t.toml")).technique;
    };
    EXPECT_EQ(technique(""), Technique::multilayer);
    for (std::size_t i = 0; i < technique_names().size(); ++i) {
        const auto wanted = static_cast<Technique>(i);
        EXPECT_EQ(
            technique("[stack]\ntechnique = \"" + std::string(technique_name(wanted)) + "\"\n"),
            wanted);
    }
    EXPECT_EQ(technique("[stack]\ntechnique = \"airy\"\n"
                        "scale = { default = 1, min = 0.5, max = 2 }\n"),
              Technique::airy);
}

TEST(Template, ReadsGratingAndGlass)
{
    const auto disc = parse_template(kHead + R"([grating]
pitch_nm = { default = 1600, min = 1000, max = 3000 }
depth_nm = 110
profile = "blazed"
orders = 2
cover = { abbe = { n_d = 1.585, v_d = 30 } }
substrate = { medium = "Al/Rakic" }
)",
                                     "t.toml");
    const auto& grating = dynamic_cast<const Grating&>(*disc.kind);
    EXPECT_EQ(grating.profile, optics::ProfileKind::blazed);
    EXPECT_EQ(grating.orders, 2);
    EXPECT_EQ(std::get<AbbeMedium>(grating.cover.value), (AbbeMedium{1.585, 30.0}));

    const auto glass = parse_template(
        kHead + "[glass]\nsellmeier = { b = [0.33, 4.3356], c = [0.0306, 0.0112] }\n", "t.toml");
    EXPECT_EQ(
        std::get<SellmeierMedium>(dynamic_cast<const Glass&>(*glass.kind).medium.value).b.size(),
        2u);
}

TEST(Template, EveryShippedTemplateIsValidAndNamedAfterItsFile)
{
    const auto paths = list_resources("templates/");
    EXPECT_GE(paths.size(), 13u);
    for (const auto path : paths) {
        const auto result = parse_template(find_resource(path).value(), path);
        EXPECT_EQ("templates/" + result.id + ".toml", path);
        EXPECT_FALSE(result.description.empty()) << path;
    }
}

TEST(Template, ReportsAllProblemsOfAFileAtOnce)
{
    const std::string text = problems(R"(schema = 2
[material]
id = "../evil"
name = 7
category = "Tests"
colour = "red"
[ambient]
medium = "air"
[[layer]]
n = -1.3
thickness_nm = nan
)");
    EXPECT_EQ(text,
              "t.toml:1: schema: must be 1 (got 2)\n"
              "t.toml:3: material.id: must be a to z, 0 to 9 and _, start with a letter and be at "
              "most 63 characters long (got \"../evil\")\n"
              "t.toml:4: material.name: must be a string (got an integer)\n"
              "t.toml:2: material.source: missing; must be a string\n"
              "t.toml:6: material.colour: unknown key; allowed here: category, description, id, "
              "name, source, status, tags\n"
              "t.toml:10: layer[0].n: must be > 0 (got -1.3)\n"
              "t.toml:11: layer[0].thickness_nm: must be a finite number (got nan)\n"
              "t.toml:1: substrate: missing; must be a table that names a medium\n");
}

struct BadInput {
    const char* name;
    std::string toml;
    std::string expected;  ///< part of the message
};

void PrintTo(const BadInput& input, std::ostream* out)
{
    *out << input.name;
}

class BadTemplate : public testing::TestWithParam<BadInput> {};

TEST_P(BadTemplate, IsRefusedWithLineAndField)
{
    const std::string text = problems(GetParam().toml);
    EXPECT_NE(text.find(GetParam().expected), std::string::npos) << text;
}

std::string layer(const std::string& keys)
{
    return kFilm + "[[layer]]\n" + keys + "\n";
}

std::string many_layers(int count)
{
    std::string result = kFilm;
    for (int i = 0; i < count; ++i) result += "[[layer]]\nn = 1.5\nthickness_nm = 100\n";
    return result;
}

INSTANTIATE_TEST_SUITE_P(
    Values, BadTemplate,
    testing::Values(
        BadInput{"negative_thickness", layer("n = 1.3\nthickness_nm = -5"),
                 "t.toml:13: layer[0].thickness_nm: must be ≥ 0 (got -5)"},
        BadInput{"infinite_thickness", layer("n = 1.3\nthickness_nm = inf"),
                 "layer[0].thickness_nm: must be a finite number (got inf)"},
        BadInput{"zero_index", layer("n = 0\nthickness_nm = 5"),
                 "t.toml:12: layer[0].n: must be > 0 (got 0)"},
        BadInput{"gain", layer("n = 1.5\nk = -0.1\nthickness_nm = 5"),
                 "t.toml:13: layer[0].k: must be in [0, 100] (got -0.1)"},
        BadInput{"min_above_max",
                 layer("n = 1.3\nthickness_nm = { default = 5, min = 9, max = 2 }"),
                 "layer[0].thickness_nm.min: must be below max (got 9 and 2)"},
        BadInput{"default_outside",
                 layer("n = 1.3\nthickness_nm = { default = 50, min = 0, max = 20 }"),
                 "layer[0].thickness_nm.default: must be inside [min, max] (got 50)"},
        BadInput{"slider_without_range",
                 layer("n = 1.3\nthickness_nm = { default = 50, varies = true }"),
                 "layer[0].thickness_nm.max: missing"},
        BadInput{"two_media", layer("n = 1.3\nmedium = \"air\"\nthickness_nm = 5"),
                 "must be given by exactly one of medium, n, cauchy, sellmeier, abbe"},
        BadInput{"no_medium", layer("thickness_nm = 5"), "layer[0].medium: must be given by"},
        BadInput{"sellmeier_sizes", layer("sellmeier = { b = [1, 2], c = [1] }\nthickness_nm = 5"),
                 "layer[0].sellmeier.c: must have as many numbers as b (got 1 and 2)"},
        BadInput{"cauchy_size", layer("cauchy = [1, 2, 3, 4]\nthickness_nm = 5"),
                 "layer[0].cauchy: must be 1 to 3 finite numbers"},
        BadInput{"k_with_library", layer("medium = \"Fe/Johnson\"\nk = 1\nthickness_nm = 5"),
                 "layer[0].k: unknown key"},
        BadInput{"thickness_text", layer("n = 1.3\nthickness_nm = \"thin\""),
                 "layer[0].thickness_nm: must be a number (got a string)"},
        BadInput{"coherent_number", layer("n = 1.3\nthickness_nm = 5\ncoherent = 1"),
                 "layer[0].coherent: must be true or false (got an integer)"},
        BadInput{"thick_layer_varies",
                 layer("n = 1.3\ncoherent = false\n"
                       "thickness_nm = { default = 5, min = 0, max = 9, varies = true }"),
                 "layer[0].coherent: a layer that varies must be coherent"},
        BadInput{"layer_as_table", kFilm + "[layer]\nn = 1.5\n",
                 "t.toml:11: layer: must be an array of tables"},
        BadInput{"layer_of_numbers", "layer = [1]\n" + kFilm,
                 "t.toml:1: layer[0]: must be a table (got an integer)"}),
    [](const auto& input) { return std::string(input.param.name); });

const std::string kVarying =
    "[[layer]]\nn = 1.3\nthickness_nm = { default = 5, min = 0, max = 9, varies = true }\n";

INSTANTIATE_TEST_SUITE_P(
    Structure, BadTemplate,
    testing::Values(
        BadInput{"too_many_layers", many_layers(65), "layer: must be at most 64 layers"},
        BadInput{"too_many_by_group",
                 layer("repeat = 13\ngroup = [{n=1.5,thickness_nm=1},{n=1.5,thickness_nm=1},"
                       "{n=1.5,thickness_nm=1},{n=1.5,thickness_nm=1},{n=1.5,thickness_nm=1}]"),
                 "layer: must be at most 64 layers"},
        BadInput{"two_vary", kFilm + kVarying + kVarying,
                 "t.toml:16: layer[1].thickness_nm: only one layer can vary"},
        BadInput{"group_varies",
                 layer("group = [{ n = 1.3, thickness_nm = { default = 5, min = 0, max = 9, "
                       "varies = true } }]"),
                 "layer[0].group[0].thickness_nm: a layer of a group cannot vary"},
        BadInput{"empty_group", layer("repeat = 2\ngroup = []"), "layer[0].group: must hold"},
        BadInput{"scale_and_varies",
                 kFilm + kVarying + "[stack]\nscale = { default = 1, min = 0.5, max = 2 }\n",
                 "t.toml:15: stack.scale: excludes a layer that varies"},
        BadInput{"technique",
                 layer("n = 1.3\nthickness_nm = 5") + "[stack]\ntechnique = \"fresnel\"\n",
                 "stack.technique: must be one of multilayer, path_difference, airy, series, "
                 "opaque_base, free_film, etalon, recursion (got \"fresnel\")"},
        BadInput{"empty_stack", layer("n = 1.3\nthickness_nm = 5") + "[stack]\n", "stack.scale: "},
        BadInput{"scale_of_nothing",
                 kFilm + "[stack]\nscale = { default = 1, min = 0.5, max = 2 }\n",
                 "stack.scale: needs a coherent layer"},
        BadInput{"base_that_transmits",
                 kFilm + "[surface]\ntransmission = true\ndiffuse_base = [1, 1, 1]\n",
                 "surface.diffuse_base: excludes transmission"},
        BadInput{"brushed_glass", kFilm + "[surface]\ntransmission = true\nanisotropy = 0.5\n",
                 "surface.anisotropy: excludes transmission"},
        BadInput{"anisotropy_of_needles", kFilm + "[surface]\nanisotropy = 1\n",
                 "surface.anisotropy"},
        BadInput{"base_of_one_number", kFilm + "[surface]\ndiffuse_base = [0.5]\n",
                 "surface.diffuse_base: must be 3 to 3 finite numbers"},
        BadInput{"base_above_white", kFilm + "[surface]\ndiffuse_base = [0.5, 1.5, 1]\n",
                 "surface.diffuse_base: must be in [0, 1] (got 1.5)"},
        BadInput{"absorbing_ambient", kHead + "[ambient]\nn = 1.5\nk = 0.1\n[substrate]\nn = 1.5\n",
                 "t.toml:7: ambient: must not absorb"},
        BadInput{"two_kinds", kHead + "[glass]\nn = 1.5\n[grating]\npitch_nm = 5\n",
                 "t.toml:7: glass: excludes [grating]"},
        BadInput{"layers_of_a_glass", kHead + "[glass]\nn = 1.5\n[ambient]\nn = 1\n",
                 "t.toml:9: ambient: unknown key"},
        BadInput{
            "grating_profile",
            kHead + "[grating]\npitch_nm = 1600\ndepth_nm = 1\nprofile = \"square\"\n",
            "grating.profile: must be one of sinusoidal, rectangular, blazed (got \"square\")"},
        BadInput{"parameter_unknown",
                 kFilm + "[[parameter]]\nname = \"shine\"\nlabel = \"Shine\"\ndefault = 1\n",
                 "t.toml:12: parameter[0].name: unknown parameter; allowed here: coverage, "
                 "roughness (got \"shine\")"},
        BadInput{"parameter_twice",
                 kFilm + "[[parameter]]\nname = \"coverage\"\nlabel = \"A\"\ndefault = 1\n"
                         "[[parameter]]\nname = \"coverage\"\nlabel = \"B\"\ndefault = 1\n",
                 "parameter[1].name: already declared"},
        BadInput{"parameter_range",
                 kFilm + "[[parameter]]\nname = \"coverage\"\nlabel = \"A\"\ndefault = 0.1\n"
                         "min = 0.5\n",
                 "parameter[0].default: must be in [0.5, 1] (got 0.1)"},
        BadInput{"no_material", "schema = 1\n[ambient]\nn = 1\n[substrate]\nn = 1\n",
                 "t.toml:1: material: missing"},
        BadInput{"not_toml", "schema = = 1\n", "t.toml:1: "},
        BadInput{"control_character", "schema = 1\n[material]\nname = \"a\\u0007b\"\n",
                 "t.toml:3: material.name: must be one line of text"},
        BadInput{"empty_file", "", "schema: missing"}),
    [](const auto& input) { return std::string(input.param.name); });

TEST(Limits, HoldForTemplates)
{
    EXPECT_INPUT_ERROR((void)parse_template(std::string(kMaxTextBytes + 1, '#'), "x.toml"),
                       "x.toml: must not be larger than 16777216 bytes");
    std::string wrong;
    for (int i = 0; i < 100; ++i) wrong += "unknown_" + std::to_string(i) + " = 1\n";
    const std::string message =
        test::input_error_of([&] { (void)parse_template(wrong, "x.toml"); });
    EXPECT_EQ(std::ranges::count(message, '\n'), kMaxProblems - 1);
    EXPECT_TRUE(message.ends_with("; there is more that is wrong"));

    std::string deep = "a = ";
    for (int i = 0; i < 100'000; ++i) deep += "[";
    EXPECT_INPUT_ERROR((void)parse_template(deep, "x.toml"),
                       "exceeded maximum nested value depth of 256");
}

std::string dotted(std::size_t parts)
{
    std::string key = "a";
    for (std::size_t i = 1; i < parts; ++i) key += " . a";
    return key;
}

TEST(Limits, HoldForDottedKeys)
{
    const std::string endless = dotted(100'000);
    for (const std::string& key : {dotted(kMaxKeyParts + 1), endless}) {
        const std::string texts[] = {key + " = 1",
                                     "[" + key + "]",
                                     "[[" + key + "]]",
                                     "b = { " + key + " = 1 }",
                                     "b = [ {" + key + " = 1} ]",
                                     R"("x".'y'.)" + key,
                                     "b = 'a\\'\n" + key,
                                     "b = ''\n" + key,
                                     "b = \"\\\"\"\n" + key,
                                     "b = \"\"\"\n\\\"\"\"\"\"\"\n" + key};
        for (const std::string& text : texts) {
            const auto line = 2 + std::ranges::count(text, '\n');
            EXPECT_INPUT_ERROR(
                (void)parse_template("# 1.2.3\n" + text, "x.toml"),
                "x.toml:" + std::to_string(line) + ": must not have keys of more than 16 parts");
        }
    }
    const std::string longest = dotted(kMaxKeyParts);
    const std::string texts[] = {longest + " = 1",
                                 "[" + longest + "]",
                                 "# " + endless,
                                 "b = \"" + endless + "\"",
                                 "b = '" + endless + "'",
                                 "b = '''\n" + endless + "\n'''",
                                 "b = \"\"\"\n\\\"\"\"" + endless + "\"\"\"\"\"",
                                 "b = [1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5,"
                                 "1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 1.5]"};
    for (const std::string& text : texts)
        EXPECT_INPUT_ERROR((void)parse_template(text, "x.toml"), "schema: missing");
}

}  // namespace
}  // namespace nacre::kinds
