// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "nacre/kinds/film.h"
#include "nacre/kinds/held_media.h"
#include "nacre/kinds/read_template.h"
#include "nacre/library/media_library.h"
#include "nacre/lut/film_table.h"
#include "nacre/pipeline/compile.h"
#include "support/expect.h"

namespace nacre::pipeline {
namespace {

using spectral::delta_e_2000, spectral::multiply, spectral::RangeRule, spectral::Vec3;

/// A film of `layer` in air.
kinds::MaterialTemplate film(const std::string& layer, const std::string& substrate)
{
    return kinds::parse_template(R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
medium = ")" + layer + R"("
thickness_nm = { default = 100, min = 0, max = 600, varies = true }
[substrate]
medium = ")" + substrate + "\"\n",
                                 "t.toml");
}

/// Coarse tables, to be quick.
CompileOptions with_rule(RangeRule rule)
{
    CompileOptions options;
    options.tolerance = 2.0;
    options.range = rule;
    return options;
}

TEST(HeldMedia, AreInTheManifest)
{
    const auto compiled =
        compile(film("BaTiO3/Wemple-o", "N-SF11/SCHOTT"), with_rule(RangeRule::hold_ends));
    const auto manifest = nlohmann::json::parse(compiled.manifest);
    const auto& held = manifest["held_ends"];
    ASSERT_EQ(held.size(), 2U);
    EXPECT_EQ(held[0]["medium"], "BaTiO3/Wemple-o");
    EXPECT_EQ(held[0]["range_nm"], (std::vector<double>{400.0, 700.0}));
    EXPECT_NEAR(held[0]["percent"].get<double>(), 0.0402, 5e-5);
    EXPECT_EQ(held[0]["note"],
              "BaTiO3/Wemple-o: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous "
              "weight (D65, cie1931)");
    EXPECT_EQ(held[1]["medium"], "N-SF11/SCHOTT");

    const auto whole = compile(film("SiO2/Malitson", "Ag/Johnson"), with_rule(RangeRule::strict));
    EXPECT_FALSE(nlohmann::json::parse(whole.manifest).contains("held_ends"));
}

TEST(HeldMedia, AreRefusedWithTheirLines)
{
    const auto refused = [](const char* layer, const char* substrate, RangeRule rule) {
        return test::input_error_of(
            [&] { (void)kinds::film_request(film(layer, substrate), with_rule(rule)); });
    };
    const std::string strict = refused("BaTiO3/Wemple-o", "N-SF11/SCHOTT", RangeRule::strict);
    EXPECT_NE(strict.find("t.toml:10: layer[0].medium: must be within the data, 400 … 700 nm (got "
                          "360); without --strict-range"),
              std::string::npos)
        << strict;
    EXPECT_NE(strict.find("t.toml:13: substrate.medium: must be within the data, 370 … 2500 nm"),
              std::string::npos)
        << strict;
    EXPECT_EQ(refused("TiO2/Devore-o", "Ag/Johnson", RangeRule::hold_ends),
              "t.toml:10: layer[0].medium: must be within the data, 430 … 1530 nm (got 400); what "
              "is needed is 400 … 700 nm, beyond which n and k may be held at their ends");
}

TEST(HeldMedia, MayBeOfGlassesAndGratings)
{
    const std::string head = R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
)";
    for (const auto& [text, medium] :
         {std::pair{std::string("[glass]\nmedium = \"N-SF11/SCHOTT\"\n"), "N-SF11/SCHOTT"},
          {"[grating]\npitch_nm = 1600\ndepth_nm = 110\nprofile = \"rectangular\"\n"
           "cover = { medium = \"glycerol/Gupta\" }\nsubstrate = { medium = \"Ag/Johnson\" }\n",
           "glycerol/Gupta"}}) {
        const auto source = kinds::parse_template(head + text, "t.toml");
        const auto manifest =
            nlohmann::json::parse(compile(source, with_rule(RangeRule::hold_ends)).manifest);
        ASSERT_EQ(manifest["held_ends"].size(), 1U) << medium;
        EXPECT_EQ(manifest["held_ends"][0]["medium"], medium);
        EXPECT_INPUT_ERROR((void)compile(source, with_rule(RangeRule::strict)),
                           "without --strict-range");
    }
}

// All that come with Nacre, each a film on silicon.
TEST(HeldMedia, MakeAllShippedMediaUsableButFive)
{
    std::vector<std::string> refused;
    std::size_t held = 0;
    const auto keys = spectral::library_keys();
    for (const std::string& key : keys) {
        const auto source = film(key, "Si/Green-2008");
        try {
            const lut::FilmTableRequest request =
                kinds::film_request(source, with_rule(RangeRule::hold_ends));
            const lut::FilmColour colour = exact_film_colour(request, 0.7, 150.0);
            for (const double channel : colour.reflectance) EXPECT_TRUE(std::isfinite(channel));
            held += held_media(source, with_rule(RangeRule::hold_ends)).size();
        } catch (const InputError&) {
            refused.push_back(key);
        }
    }
    EXPECT_EQ(refused, (std::vector<std::string>{"PC/Sultanova", "PMMA/Sultanova", "PS/Sultanova",
                                                 "TiO2/Devore-e", "TiO2/Devore-o"}));
    EXPECT_EQ(held, 53U);
    EXPECT_EQ(keys.size(), 202U);
}

/// What is known of a medium from 400 to 700 nm.
class Cut final : public spectral::OpticalConstants {
public:
    explicit Cut(spectral::OpticalConstantsPtr whole) : whole_(std::move(whole)) {}
    [[nodiscard]] spectral::Complex at(double nm) const override
    {
        EXPECT_TRUE(nm >= 400.0 && nm <= 700.0);
        return whole_->at(nm);
    }
    [[nodiscard]] std::array<double, 2> range_nm() const noexcept override
    {
        return {400.0, 700.0};
    }

private:
    spectral::OpticalConstantsPtr whole_;
};

lut::IndexOnGrid cut(const char* key)
{
    const auto medium = std::make_shared<Cut>(spectral::library_medium(key).constants);
    return spectral::WorkingRange(RangeRule::hold_ends).cover(medium)->on_grid();
}

Vec3 lab(const lut::FilmTableRequest& request, const Vec3& rgb)
{
    return spectral::xyz_to_lab(multiply(request.weights.to_xyz_d65, rgb), spectral::d65_white());
}

/// Over thicknesses of 0 … 600 nm and angles of 0 … 84 degrees.
double largest_difference(const lut::FilmTableRequest& a, const lut::FilmTableRequest& b)
{
    double largest = 0.0;
    for (double nm = 0.0; nm <= 600.0; nm += 20.0)
        for (double cosine = 1.0; cosine > 0.05; cosine -= 0.1)
            largest = std::max(largest,
                               delta_e_2000(lab(a, exact_film_colour(a, cosine, nm).reflectance),
                                            lab(b, exact_film_colour(b, cosine, nm).reflectance)));
    return largest;
}

// Data cut to 400 … 700 nm colour films as the whole data do: cpp_tools/doc/conventions.md states
// the largest difference.
TEST(HeldMedia, ColourFilmsAsTheWholeDataDo)
{
    for (const auto& [layer, substrate] : {std::pair{"TiO2/Sarkar", "Si/Green-2008"},
                                           {"TiO2/Sarkar", "Ag/Johnson"},
                                           {"SiO2/Malitson", "Cu/Johnson"},
                                           {"Ag/Johnson", "N-BK7/SCHOTT"},
                                           {"Cu/Johnson", "N-BK7/SCHOTT"}}) {
        const lut::FilmTableRequest whole =
            kinds::film_request(film(layer, substrate), with_rule(RangeRule::hold_ends));
        lut::FilmTableRequest held = whole;
        held.stack.layers[0].n = cut(layer);
        held.stack.substrate = cut(substrate);
        EXPECT_LT(largest_difference(whole, held), 0.04) << layer << " on " << substrate;
    }
}

}  // namespace
}  // namespace nacre::pipeline
