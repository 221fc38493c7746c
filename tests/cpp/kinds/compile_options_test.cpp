// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/compile_options.h"

#include <gtest/gtest.h>

namespace nacre::kinds {
namespace {

TEST(CompileOptions, WeighAWhiteAsWhite)
{
    spectral::Sampled white{};
    white.fill(1.0);
    for (const char* space : {"lin_rec709_scene", "lin_ap1_scene"}) {
        CompileOptions options;
        options.space = space;
        const spectral::ColourWeights weights = options.weights();
        EXPECT_EQ(weights.space, space);
        for (const double channel : weights.apply(white)) EXPECT_NEAR(channel, 1.0, 1e-12);
    }
}

TEST(CompileOptions, PreferTheirOwnSpace)
{
    CompileOptions options;
    options.custom_space = spectral::colour_space("lin_rec2020_scene");
    EXPECT_EQ(options.weights().space, "lin_rec2020_scene");
}

}  // namespace
}  // namespace nacre::kinds
