// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film_preview.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/kinds/read_template.h"
#include "nacre/lut/film_table.h"

namespace nacre::kinds {
namespace {

std::string text_of(const std::string& id)
{
    return std::string(find_resource("templates/" + id + ".toml").value());
}

MaterialTemplate parsed(const std::string& id)
{
    return parse_template(text_of(id), id + ".toml");
}

std::vector<TableLayout> layout_of(const Prepared& compiled)
{
    std::vector<TableLayout> layout;
    for (const lut::Table& table : compiled.tables)
        layout.push_back({table.role, {table.x.texels, table.y.texels}});
    return layout;
}

TEST(PreviewTables, FitEveryKindOfFilm)
{
    for (const char* id : {"soap_film", "oil_on_water", "jewel_beetle", "dichroic_mirror"}) {
        const auto source = parsed(id);
        CompileOptions options;
        options.tolerance = 1.0;
        const Prepared compiled = film_of(source).prepare(source, options);
        auto layout = layout_of(compiled);
        std::ranges::reverse(layout);  // any order
        auto quick = preview_tables(source, options, layout);
        std::ranges::reverse(quick);
        std::size_t found = 0;
        for (const lut::Table& table : compiled.tables) {
            if (table.role.content == TableContent::further ||
                table.role.content == TableContent::powers)
                continue;
            ASSERT_LT(found, quick.size());
            const lut::Table& same = quick[found++];
            EXPECT_EQ(same.role, table.role);
            ASSERT_EQ(same.texels.size(), table.texels.size()) << id << ' ' << table.name();
            double sum = 0.0;
            for (std::size_t i = 0; i < table.texels.size(); ++i)
                sum += std::abs(same.texels[i] - table.texels[i]);
            const double allowed = table.slices > 1 ? 0.05 : 0.002;
            EXPECT_LT(sum / static_cast<double>(table.texels.size()), allowed)
                << id << ' ' << table.name();
        }
        EXPECT_EQ(found, quick.size());
    }
}

std::string with_technique(const std::string& technique)
{
    return text_of("soap_film") + "\n[stack]\ntechnique = \"" + technique + "\"\n";
}

TEST(PreviewTables, FollowTheTechnique)
{
    const std::vector<TableLayout> layout{{{TableOf::R}, {65, 65}}, {{TableOf::T}, {65, 65}}};
    const auto texels = [&layout](const std::string& technique) {
        const auto source = parse_template(with_technique(technique), "t.toml");
        return preview_tables(source, {}, layout).front().texels;
    };
    const auto mean_difference = [](const std::vector<float>& a, const std::vector<float>& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
        return sum / static_cast<double>(a.size());
    };
    const auto multilayer = texels("multilayer");
    EXPECT_LT(mean_difference(texels("free_film"), multilayer), 1e-4);
    EXPECT_LT(mean_difference(texels("recursion"), multilayer), 1e-4);
    EXPECT_GT(mean_difference(texels("path_difference"), multilayer), 0.1);
}

TEST(FilmSpectrumOf, TheTechniqueAsked)
{
    const auto at = [](const std::string& technique) {
        const auto source = parse_template(with_technique(technique), "t.toml");
        return film_spectrum(source, {}, 0.2, 400.0);
    };
    const FilmSpectrum exact = at("multilayer"), free = at("free_film"), cut = at("series"),
                       bands = at("path_difference");
    double loss = 0.0;
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        EXPECT_NEAR(free.reflectance[i], exact.reflectance[i], 1e-12);
        EXPECT_NEAR(bands.reflectance[i] + bands.transmittance[i], 1.0, 1e-12);
        loss = std::max(loss, std::abs(1.0 - cut.reflectance[i] - cut.transmittance[i]));
    }
    EXPECT_GT(loss, 0.01);
}

TEST(PreviewTables, FollowAnEdit)
{
    std::string text = text_of("dichroic_mirror");
    const std::vector<TableLayout> layout{{{TableOf::R}, {64, 1}}};
    const auto green = preview_tables(parse_template(text, "t.toml"), {}, layout).front().texels;
    for (const std::string from : {"57.3", "94.2"})
        for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at))
            text.replace(at, from.size(), from == "57.3" ? "67.7" : "111.3");
    const auto red = preview_tables(parse_template(text, "t.toml"), {}, layout).front().texels;
    const std::size_t normal = 3 * 63;
    EXPECT_GT(green[normal + 1], green[normal]);
    EXPECT_GT(red[normal], red[normal + 1]);
}

TEST(PreviewTables, RefuseWhatSuchAFilmDoesNotHave)
{
    const auto source = parsed("tempered_steel");
    const auto problem = [&](TableRole role, lut::TexelSize size) -> std::string {
        try {
            static_cast<void>(preview_tables(source, {}, std::vector<TableLayout>{{role, size}}));
        } catch (const InputError& error) {
            return error.diagnostics().front().text();
        }
        return "";
    };
    EXPECT_EQ(problem({TableOf::T}, {64, 64}),
              "tempered_steel.toml: such a film has no table T; compile it anew");
    EXPECT_EQ(problem({TableOf::R}, {64, 1}),
              "tempered_steel.toml: table R cannot be 64 x 1; compile it anew");
    EXPECT_EQ(problem({TableOf::R, TableContent::rough}, {13, 64}),
              "tempered_steel.toml: table R_rough cannot be 13 x 64; compile it anew");
    EXPECT_EQ(problem({TableOf::R, TableContent::rough}, {205, 64}),
              "tempered_steel.toml: table R_rough cannot be 205 x 64; compile it anew");
    EXPECT_EQ(problem({TableOf::R}, {64, 64}), "");
}

TEST(FilmSpectrum, IsWhatTheTableIsMadeFrom)
{
    for (const auto& [id, value] :
         {std::pair{"soap_film", 420.0}, {"jewel_beetle", 1.1}, {"dichroic_mirror", 1.0}}) {
        const auto source = parsed(id);
        const auto spectrum = film_spectrum(source, {}, 0.7, value);
        const lut::FilmColour exact = lut::exact_film_colour(film_request(source, {}), 0.7, value);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(spectrum.colour.reflectance[c], exact.reflectance[c], 1e-9) << id;
            EXPECT_NEAR(spectrum.colour.transmittance[c], exact.transmittance[c], 1e-9) << id;
        }
    }
}

}  // namespace
}  // namespace nacre::kinds
