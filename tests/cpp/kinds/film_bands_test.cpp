// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film_bands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/kinds/read_template.h"

namespace nacre::kinds {
namespace {

MaterialTemplate shipped_film(const std::string& id)
{
    return parse_template(find_resource("templates/" + id + ".toml").value(), id + ".toml");
}

spectral::Sampled at_nm(int nm)
{
    spectral::Sampled weights{};
    weights[static_cast<std::size_t>(nm - spectral::kFirstNm)] = 1.0;
    return weights;
}

std::vector<BandPass> two_passes()
{
    return {{at_nm(450), at_nm(550), at_nm(650)}, {at_nm(460), at_nm(560), at_nm(700)}};
}

constexpr int kNm[2][3] = {{450, 550, 650}, {460, 560, 700}};

TEST(BandTables, AreReflectancesOfOnePassBelowAnother)
{
    const auto source = shipped_film("soap_film");
    const std::vector<TableLayout> layout{{{TableOf::T}, {33, 17}}, {{TableOf::R}, {33, 17}}};
    const auto tables = band_tables(source, {}, two_passes(), layout);
    ASSERT_EQ(tables.size(), 2U);
    EXPECT_EQ(tables[0].role, TableRole{TableOf::T});
    const lut::Table& R = tables[1];
    EXPECT_EQ(R.x.texels, 33);
    EXPECT_EQ(R.y.texels, 34);
    ASSERT_EQ(R.texels.size(), 3U * 33U * 34U);
    for (const std::size_t pass : {0U, 1U})
        for (const std::size_t row : {0U, 5U, 16U})
            for (const std::size_t column : {4U, 20U, 32U}) {
                const double value =
                    R.y.min + (R.y.max - R.y.min) * static_cast<double>(row) / 16.0;
                const FilmSpectrum exact =
                    film_spectrum(source, {}, static_cast<double>(column) / 32.0, value);
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto at = static_cast<std::size_t>(kNm[pass][c] - spectral::kFirstNm);
                    const std::size_t texel = 3 * ((17 * pass + row) * 33 + column) + c;
                    EXPECT_NEAR(R.texels[texel], exact.reflectance[at], 1e-5);
                    EXPECT_NEAR(tables[0].texels[texel], exact.transmittance[at], 1e-5);
                }
            }
}

/// A pass of bands as wide as the eye's own weights is what a colour is made of.
TEST(BandTables, AreThoseOfAColourWhereWeightsAre)
{
    for (const char* id : {"soap_film", "oil_on_water", "jewel_beetle", "dichroic_mirror"}) {
        const auto source = shipped_film(id);
        CompileOptions options;
        options.tolerance = 1.0;
        options.space = "xyz_d65";  // weights that are ≥ 0
        const Prepared compiled = film_of(source).prepare(source, options);
        std::vector<TableLayout> layout;
        for (const lut::Table& table : compiled.tables)
            layout.push_back({table.role, {table.x.texels, table.y.texels}});
        const std::vector<BandPass> eye{options.weights().weight};
        const auto tables = band_tables(source, options, eye, layout);
        std::size_t found = 0;
        for (const lut::Table& table : compiled.tables) {
            if (table.role.content == TableContent::powers || table.role.of == TableOf::lobe_R ||
                table.role.of == TableOf::lobe_T)
                continue;
            ASSERT_LT(found, tables.size());
            const lut::Table& same = tables[found++];
            EXPECT_EQ(same.role, table.role);
            ASSERT_EQ(same.texels.size(), table.texels.size()) << id << ' ' << table.name();
            double largest = 0.0;
            for (std::size_t i = 0; i < table.texels.size(); ++i)
                largest = std::max<double>(largest, std::abs(same.texels[i] - table.texels[i]));
            EXPECT_LT(largest, 2e-3) << id << ' ' << table.name();  // texels are rounded there
            EXPECT_TRUE(std::isnan(same.error_max));
        }
        EXPECT_EQ(found, tables.size()) << id;
    }
}

TEST(BandTables, RefuseWhatSuchAFilmDoesNotHave)
{
    const auto source = shipped_film("tempered_steel");
    const auto problem = [&](std::vector<TableLayout> layout) -> std::string {
        try {
            static_cast<void>(band_tables(source, {}, two_passes(), layout));
        } catch (const InputError& error) {
            return error.diagnostics().front().text();
        }
        return "";
    };
    EXPECT_EQ(problem({{{TableOf::R}, {33, 33}}, {{TableOf::T}, {33, 33}}}),
              "tempered_steel.toml: such a film has no table T; compile it anew");
    EXPECT_EQ(problem({{{TableOf::R}, {33, 33}}, {{TableOf::R, TableContent::rough}, {33, 33}}})
                  .substr(0, 53),
              "tempered_steel.toml: table R_rough cannot be 33 x 33;");
    EXPECT_EQ(problem({{{TableOf::R}, {33, 33}}}), "");
    EXPECT_THROW(static_cast<void>(band_tables(shipped_film("diamond"), {}, two_passes(), {})),
                 InputError);
}

TEST(OpticalThickness, IsThatOfTheThickestFilm)
{
    const char* text = R"(
schema = 1
[material]
id = "t"
name = "T"
category = "Films"
description = "A film"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 1.5
thickness_nm = { default = 100, min = 0, max = 1000, varies = true }
[[layer]]
n = 2.0
thickness_nm = 50
[substrate]
n = 1.3
)";
    EXPECT_NEAR(optical_thickness_nm(parse_template(text, "t.toml"), {}), 1600.0, 1e-9);
}

}  // namespace
}  // namespace nacre::kinds
