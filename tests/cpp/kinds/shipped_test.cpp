// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/shipped.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nacre/kinds/kind.h"

namespace nacre::kinds {
namespace {

TEST(Shipped, EveryIdIsThatOfItsMaterial)
{
    const std::vector<std::string> ids = shipped_ids();
    EXPECT_TRUE(std::ranges::is_sorted(ids));
    for (const std::string& id : ids) EXPECT_EQ(shipped_template(id).value().id, id);
}

TEST(Shipped, HasTemplatesAndShadersThatAreMaterials)
{
    EXPECT_EQ(shipped_template("soap_film").value().kind->name(), "film");
    EXPECT_EQ(shipped_template("thin_film").value().kind->name(), "shader");
    EXPECT_FALSE(shipped_template("debug"));  // says nowhere that it is listed
    EXPECT_FALSE(shipped_template("no_such"));
}

}  // namespace
}  // namespace nacre::kinds
