// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/shader_tables.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "nacre/core/resources.h"
#include "nacre/kinds/media_reader.h"

namespace nacre::kinds {
namespace {

/// After a change: build write_osl_headers and let it write the header anew.
TEST(ShaderTables, CommittedHeadersAreWhatTheLibraryWrites)
{
    EXPECT_EQ(find_resource("osl/nacre/nacre_colour_tables.h").value(),
              colour_tables_header(default_colour_weights()));
    EXPECT_EQ(find_resource("osl/nacre/nacre_constants.h").value(), constants_header());
}

TEST(ShaderTables, ShadersKnowTheLineOfAbbesNumber)
{
    const std::string_view header = find_resource("osl/nacre/nacre_dispersion.h").value();
    EXPECT_NE(header.find(fmt::format("#define NACRE_LINE_D_NM {}\n", kLineD)),
              std::string_view::npos);
}

}  // namespace
}  // namespace nacre::kinds
