// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_stack.h"

#include <gtest/gtest.h>

namespace nacre::optics {
namespace {

TEST(FilmStack, LayersAreCoherentAndEvenUnlessTheySayOtherwise)
{
    const FilmStack soap{.ambient = 1.0, .layers = {{1.33, 400.0}}, .substrate = 1.0};
    EXPECT_TRUE(soap.layers[0].coherent);
    EXPECT_EQ(soap.layers[0].spread_nm, 0.0);
    EXPECT_GE(kMaxLayers, 64);
}

}  // namespace
}  // namespace nacre::optics
