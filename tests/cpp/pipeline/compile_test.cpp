// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/compile.h"
#include "nacre/kinds/read_template.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/kinds/film.h"
#include "nacre/lut/film_table.h"
#include "nacre/optics/film_model_stack.h"
#include "nacre/optics/microfacet.h"

namespace nacre::pipeline {
namespace {

using Json = nlohmann::json;

const std::string kHead = R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
)";

kinds::MaterialTemplate shipped(const std::string& id)
{
    const std::string path = "templates/" + id + ".toml";
    return kinds::parse_template(find_resource(path).value(), path);
}

/// Coarse tables, to be quick.
CompileOptions quick()
{
    CompileOptions options;
    options.tolerance = 1.0;
    return options;
}

std::string problems(const std::string& toml)
{
    try {
        static_cast<void>(compile(kinds::parse_template(toml, "t.toml"), quick()));
    } catch (const InputError& error) {
        std::string result;
        for (const Diagnostic& problem : error.diagnostics()) result += problem.text() + '\n';
        return result;
    }
    return "";
}

/// The build compiles all of them; here is one of each kind, and of each way to have tables.
TEST(Compile, ManifestTellsOfTheTables)
{
    for (const char* const id : {"n_bk7", "cd", "oil_on_water", "brushed_anodised_titanium",
                                 "jewel_beetle", "pearl_white", "soap_film", "lens_coating"}) {
        const CompiledMaterial result = compile(shipped(id), quick());
        const Json manifest = Json::parse(result.manifest);
        EXPECT_EQ(manifest["id"], id);
        EXPECT_EQ(result.id, id);
        EXPECT_EQ(manifest["tables"].size(), result.tables.size());
        for (std::size_t i = 0; i < result.tables.size(); ++i) {
            const lut::Table& table = result.tables[i];
            EXPECT_EQ(manifest["tables"][i]["name"], table.name());
            EXPECT_EQ(manifest["tables"][i]["width"], table.x.texels);
            EXPECT_EQ(manifest["tables"][i]["height"], table.y.texels);
            if (table.slices > 1) {
                EXPECT_LE(table.error_mean, 0.5) << id << ' ' << table.name();
            } else if (table.error_unit == "dE00") {
                EXPECT_LE(table.error_max, quick().tolerance) << id << ' ' << table.name();
            }
        }
        EXPECT_NE(result.osl.find("shader nacre_" + result.id), std::string::npos);
    }
}

const std::string kOnGlass = kHead + R"([ambient]
medium = "air"
[[layer]]
n = 2.2
thickness_nm = { default = 100, min = 50, max = 300, varies = true }
[substrate]
medium = "N-BK7/SCHOTT"
[surface]
)";

CompiledMaterial compiled(const std::string& toml)
{
    return compile(kinds::parse_template(toml, "t.toml"), quick());
}

std::vector<std::string> names(const CompiledMaterial& material)
{
    std::vector<std::string> result;
    for (const lut::Table& table : material.tables) result.push_back(table.name());
    return result;
}

TEST(Compile, FilmOnSolidGlassRefracts)
{
    const CompiledMaterial result = compiled(kOnGlass + "transmission = true\n");
    EXPECT_EQ(names(result), (std::vector<std::string>{"R", "R_rough", "T", "T_rough", "lobe_R",
                                                       "lobe_R_rough", "lobe_T", "lobe_T_rough"}));
    EXPECT_NE(result.osl.find("nacre_coated_glass(surface_normal, roughness, 1.5168"),
              std::string::npos);
    const Json manifest = Json::parse(result.manifest);
    bool refracts = false;
    for (const Json& node : manifest["graphs"]["nodes"]["nodes"])
        if (node["type"] == "ShaderNodeBsdfRefraction") {
            refracts = true;
            EXPECT_NEAR(node["values"]["IOR"].get<double>(), 1.5168, 1e-4);
        }
    EXPECT_TRUE(refracts);
}

TEST(Compile, FilmOverAMattBaseHasItsInnerTables)
{
    const CompiledMaterial result =
        compiled(kOnGlass +
                 "diffuse_base = [0.8, 0.5, 0.25]\n[[parameter]]\nname = \"coverage\"\n"
                 "label = \"Coverage\"\ndefault = 1\n");
    EXPECT_EQ(names(result), (std::vector<std::string>{
                                 "R", "R_rough", "R_further", "T", "T_rough", "R_inner", "T_inner",
                                 "R_schlick", "R_bare", "R_rough_bare", "R_further_bare", "T_bare",
                                 "T_rough_bare", "R_inner_bare", "T_inner_bare"}));
    EXPECT_EQ(result.tables[5].y.texels, result.tables[0].y.texels);
    const Json sockets = Json::parse(result.manifest)["sockets"];
    EXPECT_EQ(sockets[2]["name"], "base_colour");
    EXPECT_EQ(sockets[2]["default"], Json({0.8, 0.5, 0.25}));
}

/// Luminance of a texel; light is counted by it, since channels may exceed 1 outside the gamut.
double luminance(const lut::Table& table, std::size_t texel)
{
    const float* rgb = &table.texels[3 * texel];
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

TEST(Compile, RoughFilmsMakeNoLight)
{
    for (const char* id : {"soap_film", "dichroic_mirror", "tempered_steel", "oil_on_water"}) {
        const CompiledMaterial result = compile(shipped(id), quick());
        const auto find = [&result](const char* name) {
            const auto it = std::ranges::find(result.tables, name, &lut::Table::name);
            return it == result.tables.end() ? nullptr : &*it;
        };
        const lut::Table &R = *find("R_rough"), *T = find("T_rough");
        const int width = R.x.texels / R.slices;
        for (int i = 0; i < R.x.texels; i += 3) {
            const double roughness = (i / width + 1.0) / R.slices;
            const double albedo = optics::ggx_albedo(static_cast<double>(i % width) / (width - 1),
                                                     roughness * roughness);
            for (int y = 0; y < R.y.texels; y += 7) {
                const auto texel = static_cast<std::size_t>(y * R.x.texels + i);
                const double passed = T ? luminance(*T, texel) : 0.0;
                EXPECT_LE(albedo * luminance(R, texel) + passed, 1.0 + 1e-3) << id;
            }
        }
    }
}

TEST(Compile, LightCannotGoOnInAMetal)
{
    const std::string metal = kHead +
                              "[ambient]\nn = 1\n[substrate]\nmedium = \"Fe/Johnson\"\n"
                              "[surface]\ntransmission = true\n";
    EXPECT_NE(problems(metal).find("t.toml:10: substrate.medium"), std::string::npos)
        << problems(metal);
}

TEST(Compile, SoapFilmHasFadingTablesOfBothSides)
{
    const CompiledMaterial result = compile(shipped("soap_film"), quick());

    EXPECT_EQ(names(result), (std::vector<std::string>{
                                 "R", "R_rough", "R_further", "T", "T_rough", "R_schlick", "R_bare",
                                 "R_rough_bare", "R_further_bare", "T_bare", "T_rough_bare"}));
    EXPECT_EQ(result.tables[6].y.texels, 1);
    for (const float value : result.tables[6].texels) EXPECT_NEAR(value, 0.0, 1e-7);
    for (const float value : result.tables[9].texels) EXPECT_NEAR(value, 1.0, 1e-6);
}

TEST(Compile, ClearFilmLosesNoLight)
{
    const CompiledMaterial result = compile(shipped("soap_film"), quick());
    const lut::Table &r = result.tables[0], &t = result.tables[3];
    ASSERT_EQ(r.texels.size(), t.texels.size());
    // To 1e-5 but for rounding, which is that of texels from ½ to 2 and of those below ½ and
    // negative.
    double lost = 0.0;
    for (std::size_t i = 0; i < r.texels.size(); ++i) {
        const double kept = double{r.texels[i]} + double{t.texels[i]};
        ASSERT_NEAR(kept, 1.0, 0x1p-14 + 0x1p-16 + 1e-5);
        lost += 1.0 - kept;
    }
    EXPECT_NEAR(lost / static_cast<double>(r.texels.size()), 0.0, 1e-6);
}

/// Catalogue values: SCHOTT N-BK7 1.52238, 1.51680, 1.51432; the rest from their formulas.
TEST(Compile, GlassStatesItsIndexAtTheFraunhoferLines)
{
    const Json lines = Json::parse(compile(shipped("n_bk7"), quick()).manifest)["glass"]["lines"];
    EXPECT_NEAR(lines["F"].get<double>(), 1.52238, 5e-6);
    EXPECT_NEAR(lines["d"].get<double>(), 1.51680, 5e-6);
    EXPECT_NEAR(lines["C"].get<double>(), 1.51432, 5e-6);

    const Json diamond =
        Json::parse(compile(shipped("diamond"), quick()).manifest)["glass"]["lines"];
    const double n_d = diamond["d"].get<double>();
    const double abbe = (n_d - 1.0) / (diamond["F"].get<double>() - diamond["C"].get<double>());
    EXPECT_NEAR(n_d, 2.41749, 1e-4);
    EXPECT_NEAR(abbe, 55.3, 0.1);
}

TEST(Compile, GratingTakesTheColourOfItsMetal)
{
    const Json manifest = Json::parse(compile(shipped("cd"), quick()).manifest);
    EXPECT_EQ(manifest["wavelength_per_path"], true);
    for (const Json& channel : manifest["sockets"][1]["default"]) {
        EXPECT_GT(channel.get<double>(), 0.80);
        EXPECT_LT(channel.get<double>(), 0.92);  // aluminium under polycarbonate
    }
}

TEST(Compile, EqualInputGivesEqualBytes)
{
    for (const char* id : {"tempered_steel", "sf11", "dvd"}) {
        const CompiledMaterial first = compile(shipped(id), quick());
        const CompiledMaterial second = compile(shipped(id), quick());
        EXPECT_EQ(first.osl, second.osl);
        EXPECT_EQ(first.manifest, second.manifest);
        ASSERT_EQ(first.tables.size(), second.tables.size());
        for (std::size_t i = 0; i < first.tables.size(); ++i)
            EXPECT_EQ(first.tables[i].texels, second.tables[i].texels);
    }
}

TEST(Compile, ReportsEveryUnknownMediumWithItsLine)
{
    const std::string text = problems(kHead + R"([ambient]
medium = "aether"
[[layer]]
medium = "Fe3O4/Nobody"
thickness_nm = 10
[substrate]
n = 1.5
)");
    EXPECT_NE(text.find("t.toml:8: ambient.medium: "), std::string::npos) << text;
    EXPECT_NE(text.find("t.toml:10: layer[0].medium: "), std::string::npos) << text;
}

/// Polycarbonate is measured from 437 nm on; the grid starts at 360 nm.
TEST(Compile, RefusesDataThatStopShortAndNamesTheirRange)
{
    const std::string text = problems(kHead + "[glass]\nmedium = \"PC/Sultanova\"\n");
    EXPECT_NE(text.find("t.toml:8: glass.medium: "), std::string::npos) << text;
    EXPECT_NE(text.find("436.8"), std::string::npos) << text;
}

TEST(Compile, RefusesAMetalAsGlassOrAmbient)
{
    const std::string glass = problems(kHead + "[glass]\nmedium = \"Al/Rakic\"\n");
    EXPECT_NE(glass.find("t.toml:8: glass.medium: must not absorb"), std::string::npos) << glass;
    const std::string ambient =
        problems(kHead + "[ambient]\nmedium = \"Al/Rakic\"\n[substrate]\nn = 1.5\n");
    EXPECT_NE(ambient.find("ambient.medium: must not absorb"), std::string::npos) << ambient;
}

/// A film of 20 … 500 nm that a technique is asked for.
std::string by_technique(const std::string& technique, const std::string& film,
                         const std::string& base, const std::string& surface = "")
{
    return kHead + "[ambient]\nn = 1\n[[layer]]\n" + film +
           "\nthickness_nm = { default = 100, min = 20, max = 500, varies = true }\n[substrate]\n" +
           base + "\n[stack]\ntechnique = \"" + technique + "\"\n[surface]\n" + surface;
}

lut::FilmTableRequest request_of(const std::string& toml)
{
    return kinds::film_request(kinds::parse_template(toml, "t.toml"), quick());
}

TEST(Technique, NamesAreThoseOfTheForms)
{
    const auto names = kinds::technique_names();
    ASSERT_EQ(names.size(), optics::film_model_names().size() + 1);
    EXPECT_EQ(names.front(), kinds::technique_name(kinds::Technique::multilayer));
    EXPECT_TRUE(std::ranges::equal(names.subspan(1), optics::film_model_names()));
}

/// Colour of the form at one angle and thickness, summed wavelength by wavelength.
lut::FilmColour by_form(const lut::FilmTableRequest& request, double cos_theta, double thickness)
{
    spectral::Sampled R{}, T{};
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        const optics::FilmStack stack{request.stack.ambient[i],
                                      {{request.stack.layers[0].n[i], thickness}},
                                      request.stack.substrate[i]};
        const auto power = optics::film_model_power(request.technique->model, stack, cos_theta,
                                                    spectral::wavelength_nm(i), 1.0);
        R[i] = power.R;
        T[i] = power.T;
    }
    return {request.weights.apply(R), request.weights.apply(T)};
}

struct TechniqueCase {
    const char *technique, *film, *base;
    bool exact;  ///< the multilayer
};

class EveryTechnique : public testing::TestWithParam<TechniqueCase> {};

TEST_P(EveryTechnique, BakesItsOwnReflectance)
{
    const auto [technique, film, base, exact] = GetParam();
    const auto request = request_of(by_technique(technique, film, base));
    const lut::Table table = lut::bake_film_tables(request).reflectance;
    EXPECT_LE(table.error_max, quick().tolerance);
    const auto plain = request_of(by_technique("multilayer", film, base));
    ASSERT_FALSE(plain.technique.has_value());
    double differs = 0.0;
    for (const int x : {1, table.x.texels / 2, table.x.texels - 1})
        for (const int y : {0, table.y.texels / 3, table.y.texels - 1}) {
            const double cos_theta = static_cast<double>(x) / (table.x.texels - 1);
            const double thickness = 20.0 + 480.0 * y / (table.y.texels - 1);
            const spectral::Vec3 form = by_form(request, cos_theta, thickness).reflectance;
            const spectral::Vec3 multilayer =
                lut::exact_film_colour(plain, cos_theta, thickness).reflectance;
            for (std::size_t c = 0; c < 3; ++c) {
                const auto texel = static_cast<std::size_t>(y * table.x.texels + x);
                EXPECT_NEAR(table.texels[3 * texel + c], form[c], 2e-6) << technique;
                differs = std::max(differs, std::abs(form[c] - multilayer[c]));
            }
        }
    if (exact)
        EXPECT_LT(differs, 1e-9);
    else
        EXPECT_GT(differs, 1e-3);
}

constexpr const char *kWater = "medium = \"water/Daimon-20C\"", *kAir = "n = 1",
                     *kSteel = "medium = \"Fe/Johnson\"",
                     *kGlass = "abbe = { n_d = 1.5168, v_d = 64.2 }",
                     *kTitania = "cauchy = [2.2, 0.032]";

INSTANTIATE_TEST_SUITE_P(Technique, EveryTechnique,
                         testing::Values(TechniqueCase{"path_difference", kWater, kAir, false},
                                         TechniqueCase{"airy", kTitania, kGlass, true},
                                         TechniqueCase{"series", kTitania, kGlass, false},
                                         TechniqueCase{"opaque_base", kTitania, kSteel, true},
                                         TechniqueCase{"free_film", kWater, kAir, true},
                                         TechniqueCase{"etalon", kWater, kAir, true},
                                         TechniqueCase{"etalon", kTitania, kGlass, false},
                                         TechniqueCase{"recursion", kTitania, kSteel, true}),
                         [](const auto& test) {
                             return std::string(test.param.technique) + std::to_string(test.index);
                         });

TEST(Technique, LosslessFormsPassOnWhatTheyDoNotReflect)
{
    const std::string surface = "transmission = true\n";
    const auto sums = [&](const char* technique) {
        const auto tables =
            lut::bake_film_tables(request_of(by_technique(technique, kWater, kAir, surface)));
        double largest = 0.0;
        for (std::size_t i = 0; i < tables.reflectance.texels.size(); ++i) {
            const double sum = static_cast<double>(tables.reflectance.texels[i]) +
                               static_cast<double>(tables.transmittance->texels[i]);
            largest = std::max(largest, std::abs(sum - 1.0));
        }
        return largest;
    };
    EXPECT_LT(sums("etalon"), 1e-5);
    EXPECT_LT(sums("path_difference"), 1e-5);
    EXPECT_GT(sums("series"), 0.05);
}

/// All tables, the means from below among them, of forms that are exact.
TEST(Technique, ExactFormsHaveTheTablesOfTheMultilayer)
{
    const std::string surface =
        "diffuse_base = [0.8, 0.5, 0.25]\n[[parameter]]\nname = \"coverage\"\n"
        "label = \"Coverage\"\ndefault = 1\n";
    const auto all = [&](const char* technique) {
        return compiled(by_technique(technique, kTitania, kGlass, surface));
    };
    const CompiledMaterial multilayer = all("multilayer"), airy = all("airy");
    EXPECT_EQ(Json::parse(multilayer.manifest)["technique"], "multilayer");
    EXPECT_EQ(Json::parse(airy.manifest)["technique"], "airy");
    ASSERT_EQ(names(airy), names(multilayer));
    for (std::size_t i = 0; i < airy.tables.size(); ++i) {
        const lut::Table &a = airy.tables[i], &b = multilayer.tables[i];
        if (a.quantity == "schlick_coefficients") continue;  // large ones that cancel
        ASSERT_EQ(a.texels.size(), b.texels.size()) << a.name();
        for (std::size_t k = 0; k < a.texels.size(); ++k)
            ASSERT_NEAR(a.texels[k], b.texels[k], 1e-5) << a.name();
    }
}

TEST(Technique, RefusesAStackOutsideItsDomain)
{
    EXPECT_EQ(problems(by_technique("airy", kTitania, kSteel)),
              "t.toml:13: substrate.medium: must have k = 0 with technique \"airy\" (at 360 nm); "
              "choose \"multilayer\", which takes any stack\n");
    const std::string film = problems(by_technique("series", "n = 0.9\nk = 0.1", "n = 0.8"));
    EXPECT_NE(film.find("t.toml:10: layer[0].n: must have k = 0"), std::string::npos) << film;
    EXPECT_NE(film.find("t.toml:10: layer[0].n: must not be below"), std::string::npos) << film;
    EXPECT_NE(film.find("t.toml:14: substrate.n: must not be below"), std::string::npos) << film;
    const std::string two =
        by_technique("free_film", "n = 1.5\nthickness_nm = 10\n[[layer]]\nn = 1.4", kAir);
    EXPECT_NE(problems(two).find("layer: must be the only layer"), std::string::npos)
        << problems(two);
}

TEST(FilmRequest, HasTheStackOfTheTemplateOnTheGrid)
{
    const lut::FilmTableRequest request = kinds::film_request(shipped("dichroic_mirror"), quick());
    ASSERT_EQ(request.stack.layers.size(), 16u);
    EXPECT_DOUBLE_EQ(request.stack.layers[1].thickness_nm, 94.2);
    EXPECT_FALSE(request.stack.layers[15].coherent);
    EXPECT_TRUE(request.transmittance);
    EXPECT_FALSE(request.variation.has_value());
    // SiO2, Malitson 1965: 1.4585 at 589 nm.
    EXPECT_NEAR(request.stack.layers[1].n[589 - 360].real(), 1.4584, 1e-4);

    EXPECT_THROW(static_cast<void>(kinds::film_request(shipped("water"), quick())), InputError);
}

}  // namespace
}  // namespace nacre::pipeline
