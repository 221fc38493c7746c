// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/head.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "support/expect.h"

namespace nacre::material {
namespace {

constexpr std::array kSliders{SliderInfo{.name = "glow", .most = 5.0}, kRoughness};

TemplateHead head(const std::string& toml)
{
    TemplateHead result;
    read_toml(toml, "t.toml", [&](Section& root) {
        read_material(root, result);
        read_surface(root, result);
        read_parameters(root, kSliders, result);
        read_look(root, false, result);
        root.report_unknown_keys();
    });
    return result;
}

const std::string kMaterial =
    "[material]\nid = \"a\"\nname = \"A\"\ncategory = \"B\"\nsource = \"c\"\n";

TEST(Head, HasWhatEveryTemplateSays)
{
    const TemplateHead made =
        head(kMaterial +
             "status = \"sourced\"\n[surface]\nroughness = 0.3\n"
             "[[parameter]]\nname = \"glow\"\nlabel = \"Glow\"\ndefault = 2\nmax = 4\n"
             "[look]\nobject = \"vase\"\n");
    EXPECT_EQ(made.id, "a");
    EXPECT_EQ(status_name(made.status), "sourced");
    EXPECT_DOUBLE_EQ(made.roughness, 0.3);
    ASSERT_NE(made.parameter("glow"), nullptr);
    EXPECT_DOUBLE_EQ(made.parameter("glow")->max, 4.0);
    EXPECT_EQ(made.parameter("roughness"), nullptr);
    EXPECT_EQ(made.look.object, "vase");
}

TEST(Head, RefusesWhatNoSliderHas)
{
    const auto problem = [](const std::string& rest) {
        return test::input_error_of([&] { static_cast<void>(head(kMaterial + rest)); });
    };
    EXPECT_EQ(problem("[[parameter]]\nname = \"shine\"\nlabel = \"S\"\ndefault = 1\n"),
              "t.toml:7: parameter[0].name: unknown parameter; allowed here: glow, roughness (got "
              "\"shine\")");
    EXPECT_EQ(problem("[[parameter]]\nname = \"glow\"\nlabel = \"S\"\ndefault = 6\n"),
              "t.toml:9: parameter[0].default: must be in [0, 5] (got 6)");
}

TEST(Head, SchemaHasTheSlidersOfAllKinds)
{
    const SchemaJson schema =
        head_schema(std::array{FieldInfo{.key = "more"}}, std::span(kSliders));
    EXPECT_EQ(schema["parameter"]["items"]["properties"]["name"]["enum"],
              SchemaJson::array({"glow", "roughness"}));
    EXPECT_EQ(schema["parameter"]["items"]["properties"]["default"]["maximum"], 5);
    EXPECT_TRUE(schema["surface"]["properties"].contains("roughness"));
    EXPECT_TRUE(schema["surface"]["properties"].contains("more"));
}

}  // namespace
}  // namespace nacre::material
