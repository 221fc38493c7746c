// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/resources.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "support/expect.h"

namespace nacre {
namespace {

std::string file_bytes(const std::string& path)
{
    std::ifstream file(std::string(NACRE_SOURCE_DIR) + "/" + path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Resources, HoldTheFilesByteForByte)
{
    EXPECT_EQ(find_resource("templates/soap_film.toml"),
              file_bytes("osl/templates/soap_film.toml"));
    EXPECT_EQ(find_resource("osl/nacre/nacre_fresnel.h"),
              file_bytes("osl/include/nacre/nacre_fresnel.h"));
}

TEST(Resources, AreNotThereUnderAnyOtherName)
{
    EXPECT_EQ(find_resource(""), std::nullopt);
    EXPECT_EQ(find_resource("templates/"), std::nullopt);
    EXPECT_EQ(find_resource("templates/soap_film"), std::nullopt);
    EXPECT_EQ(find_resource("templates/soap_film.toml "), std::nullopt);
    EXPECT_EQ(find_resource("zzz"), std::nullopt);
}

TEST(Resources, ListInAscendingOrderAndAreAllFound)
{
    const auto paths = list_resources("");
    ASSERT_FALSE(paths.empty());
    EXPECT_TRUE(std::ranges::is_sorted(paths));
    for (const auto path : paths) EXPECT_TRUE(find_resource(path).has_value()) << path;

    const auto templates = list_resources("templates/");
    ASSERT_FALSE(templates.empty());
    for (const auto path : templates) EXPECT_TRUE(path.ends_with(".toml")) << path;
    EXPECT_TRUE(list_resources("no such folder/").empty());
}

}  // namespace
}  // namespace nacre
