// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/schema.h"

#include <gtest/gtest.h>

#include <array>

namespace nacre::material {
namespace {

TEST(Schema, OfFieldsNamesWhatIsRequired)
{
    const std::array fields{FieldInfo{.key = "a", .help = "first", .required = true},
                            FieldInfo{.key = "b"}};
    const SchemaJson schema = fields_schema(fields);
    EXPECT_EQ(schema["required"], SchemaJson::array({"a"}));
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_EQ(schema["properties"]["a"]["description"], "first");
    EXPECT_EQ(schema["properties"].size(), 2u);
}

TEST(Schema, OfAMediumHasExactlyOneForm)
{
    const SchemaJson schema = medium_schema(std::array{FieldInfo{.key = "a", .required = true}});
    EXPECT_EQ(schema["oneOf"].size(), 5u);
    EXPECT_TRUE(schema["properties"].contains("sellmeier"));
    EXPECT_TRUE(schema["properties"].contains("a"));
    EXPECT_EQ(schema["properties"]["n"]["exclusiveMinimum"], 0);
}

TEST(Schema, RefersToDefinitions)
{
    EXPECT_EQ(reference_schema("layer").dump(), R"({"$ref":"#/$defs/layer"})");
}

}  // namespace
}  // namespace nacre::material
