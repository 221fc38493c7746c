// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/program.h"

#include <gtest/gtest.h>

namespace nacre::oslgen {
namespace {

TEST(Traits, AreThoseOfAnOpaqueSurfaceUnlessSaid)
{
    const Traits traits;
    EXPECT_EQ(traits.stage, "shaderball");
    ASSERT_EQ(traits.closures.size(), 1u);
    EXPECT_EQ(traits.closures[0].output, "BSDF");
    EXPECT_FALSE(traits.editable_stack || traits.probe || traits.is_body);
}

TEST(Traits, HaveTheNamesOfTheManifest)
{
    EXPECT_EQ(closure_role_name(ClosureRole::surface), "surface");
    EXPECT_EQ(closure_role_name(ClosureRole::emission), "emission");
    EXPECT_EQ(closure_role_name(ClosureRole::volume), "volume");
    EXPECT_EQ(truth_name(Truth::none), "");
    EXPECT_EQ(truth_name(Truth::stack), "stack");
    EXPECT_EQ(truth_name(Truth::white), "white");
}

}  // namespace
}  // namespace nacre::oslgen
