// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/fields.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "support/expect.h"

namespace nacre::material {
namespace {

enum class Shape { round, square };
constexpr std::array<std::string_view, 2> kShapes{"round", "square"};

struct Spec {
    double height = 7.0;
    int count = 2;
    bool is_open = false;
    std::string note;
    Shape shape = Shape::round;
    std::optional<std::array<double, 3>> tint;
    Quantity width_nm;
    MediumSpec medium;
};

constexpr std::array kFields{
    field<&Spec::height>({.key = "height", .unit = "nm", .bounds = {0.0, 1e3}}),
    field<&Spec::count>({.key = "count", .bounds = {1.0, 9.0}}),
    field<&Spec::is_open>({.key = "is_open"}),
    field<&Spec::note>({.key = "note", .required = true}),
    field<&Spec::shape>({.key = "shape", .choices = kShapes}),
    field<&Spec::tint>({.key = "tint", .bounds = {0.0, 1.0}}),
    field<&Spec::width_nm>(
        {.key = "width_nm", .bounds = {.min = 0.0}, .required = true, .slider = Slider::may}),
    field<&Spec::medium>({.key = "medium", .is_clear = true},
                         [](const Spec& spec) { return spec.shape == Shape::round; }),
};

Spec spec(const std::string& toml)
{
    Spec result;
    read_toml(toml, "t.toml", [&](Section& root) {
        read_fields(root, kFields, result);
        root.report_unknown_keys();
    });
    return result;
}

TEST(Fields, AreReadByTheirTypes)
{
    const Spec made = spec(
        "height = 3\ncount = 4\nis_open = true\nnote = \"a\"\nshape = \"round\"\n"
        "tint = [0, 0.5, 1]\nmedium = { n = 1.5 }\n"
        "width_nm = { default = 5, min = 1, max = 9, varies = true }\n");
    EXPECT_DOUBLE_EQ(made.height, 3.0);
    EXPECT_EQ(made.count, 4);
    EXPECT_TRUE(made.is_open);
    EXPECT_EQ(made.note, "a");
    EXPECT_DOUBLE_EQ((*made.tint)[1], 0.5);
    EXPECT_TRUE(made.width_nm.varies);
    EXPECT_DOUBLE_EQ(*made.width_nm.max, 9.0);
    EXPECT_EQ(std::get<ConstantMedium>(made.medium.value).n, 1.5);
}

TEST(Fields, KeepWhatAFreshOneHas)
{
    const Spec made = spec("note = \"a\"\nwidth_nm = 1\nshape = \"square\"\n");
    EXPECT_DOUBLE_EQ(made.height, 7.0);
    EXPECT_EQ(made.count, 2);
    EXPECT_FALSE(made.tint.has_value());
}

TEST(Fields, ReportWhatIsWrong)
{
    const auto problems = [](const std::string& toml) {
        return test::input_error_of([&] { static_cast<void>(spec(toml)); });
    };
    EXPECT_EQ(
        problems("height = -1\ncount = 10\nshape = \"flat\"\ntint = [1, 2, 3]\n"
                 "medium = { n = 1.5, k = 1 }\n"),
        "t.toml:1: height: must be ≥ 0 (got -1)\n"
        "t.toml:2: count: must be in [1, 9] (got 10)\n"
        "t.toml:1: note: missing; must be a string\n"
        "t.toml:3: shape: must be one of round, square (got \"flat\")\n"
        "t.toml:4: tint: must be in [0, 1] (got 2)\n"
        "t.toml:1: width_nm: missing; must be a number ≥ 0, or { default, min, max, varies }\n"
        "t.toml:5: medium: must not absorb: k must be 0");
    EXPECT_NE(problems("note = \"a\"\nwidth_nm = 1\nshape = \"square\"\nmedium = { n = 1 }\n")
                  .find("medium: unknown key"),
              std::string::npos);
}

TEST(Fields, HaveTheirTypesAndEntries)
{
    const std::vector<FieldInfo> all = infos(kFields);
    const std::array types{FieldType::number,   FieldType::integer, FieldType::boolean,
                           FieldType::text,     FieldType::choice,  FieldType::colour,
                           FieldType::quantity, FieldType::medium};
    ASSERT_EQ(all.size(), types.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].type, types[i]) << all[i].key;
    EXPECT_EQ(wanted(all[1]), "an integer in [1, 9]");
    EXPECT_EQ(field_schema(all[0]).dump(),
              R"({"type":"number","minimum":0,"maximum":1000,"description":", nm"})");
    EXPECT_EQ(field_schema(all[4]).dump(), R"({"enum":["round","square"]})");
}

}  // namespace
}  // namespace nacre::material
