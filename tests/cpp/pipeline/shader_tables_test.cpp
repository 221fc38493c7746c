// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/shader_tables.h"

#include <gtest/gtest.h>

#include "nacre/core/resources.h"

namespace nacre::pipeline {
namespace {

/// After a change of the tables: build write_osl_colour_tables and let it write the header anew.
TEST(ShaderTables, TheCommittedHeaderIsWhatTheLibraryWrites)
{
    EXPECT_EQ(find_resource("osl/nacre/nacre_colour_tables.h").value(), colour_tables_header());
}

}  // namespace
}  // namespace nacre::pipeline
