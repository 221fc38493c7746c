// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "film/film_program.h"
#include "nacre/kinds/read_template.h"
#include "support/expect.h"

namespace nacre::kinds {
namespace {

const std::string kMadeUp = R"(schema = 1
[material]
id = "test"
name = "Test"
category = "Tests"
source = "made up"
)";

MaterialTemplate film(const std::string& rest)
{
    return parse_template(kMadeUp + R"([ambient]
medium = "air"
[[layer]]
n = 1.33
thickness_nm = { default = 400, min = 100, max = 1500, varies = true }
[substrate]
n = 1.5
)" + rest,
                          "test.toml");
}

const std::string kCoverage =
    "[[parameter]]\nname = \"coverage\"\nlabel = \"Cover\"\ndefault = 0.75\n";

lut::Table table(const TableRole& role)
{
    return {.role = role,
            .quantity = "reflectance",
            .x = {"cos_theta", "1", 0.0, 1.0, 2},
            .y = {"thickness_nm", "nm", 100.0, 1500.0, 1},
            .channels = {"R", "G", "B"},
            .texels = std::vector<float>(6, 0.5F)};
}

std::vector<std::string> names(const oslgen::Program& program)
{
    std::vector<std::string> result;
    for (const oslgen::Socket& socket : program.sockets) result.push_back(socket.name);
    return result;
}

TEST(FilmProgram, HasTheSocketsOfItsTemplateInOrder)
{
    const std::vector tables{table({TableOf::R})};
    const auto sockets = [&](const std::string& rest) {
        return names(film::program(film(rest), tables, std::nullopt, std::nullopt));
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(sockets(""), (Names{"thickness_nm", "roughness", "normal"}));
    EXPECT_EQ(sockets(kCoverage), (Names{"thickness_nm", "coverage", "roughness", "normal"}));
    EXPECT_EQ(sockets("[surface]\nanisotropy = 0.5\n"),
              (Names{"thickness_nm", "roughness", "anisotropy", "rotation", "normal", "tangent"}));
    EXPECT_EQ(sockets("[surface]\ndiffuse_base = [1, 1, 1]\n"),
              (Names{"thickness_nm", "base_colour", "roughness", "normal"}));
}

TEST(FilmProgram, DecidesByWhatLiesBelow)
{
    const std::vector tables{table({TableOf::R})};
    const auto surface = [&](const std::string& rest, std::optional<double> index) {
        return std::get<oslgen::TableSurface>(
            film::program(film(rest), tables, index, std::nullopt).body);
    };
    EXPECT_TRUE(std::holds_alternative<oslgen::OpaqueBase>(surface("", {}).below));
    EXPECT_EQ(surface("[surface]\ntransmission = true\n", 1.5).solid_index(), 1.5);
    EXPECT_TRUE(std::holds_alternative<oslgen::MattBase>(
        surface("[surface]\ndiffuse_base = [1, 1, 1]\n", {}).below));
    EXPECT_TRUE(surface("[surface]\nanisotropy = 0\n", {}).is_brushed);
    EXPECT_TRUE(surface(kCoverage, {}).fades);
    EXPECT_FALSE(surface("", {}).fades);
}

TEST(Film, IsWhatOnlyFilmsAre)
{
    EXPECT_EQ(film_of(film("")).layers.size(), 1u);
    const auto glass = parse_template(kMadeUp + "[glass]\nn = 1.5\n", "g.toml");
    EXPECT_INPUT_ERROR((void)film_of(glass), "g.toml: must be a film");
}

TEST(Film, WithoutLayersIsItsSubstrate)
{
    const MaterialTemplate whole = film("");
    const MaterialTemplate bare = without_layers(whole);
    EXPECT_TRUE(film_of(bare).layers.empty());
    EXPECT_EQ(film_of(whole).layers.size(), 1u);
    EXPECT_EQ(film_request(bare, {}).stack.layers.size(), 0u);
}

}  // namespace
}  // namespace nacre::kinds
