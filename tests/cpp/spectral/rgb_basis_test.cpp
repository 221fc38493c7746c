// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/rgb_basis.h"

#include <gtest/gtest.h>

#include "nacre/spectral/colour.h"

namespace nacre::spectral {
namespace {

TEST(RgbBasis, AddsUpToWhiteAndNeverLeavesZeroToOne)
{
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        double sum = 0.0;
        for (const Sampled& reflectance : rgb_basis()) {
            EXPECT_TRUE(reflectance[i] >= 0.0 && reflectance[i] <= 1.0) << wavelength_nm(i);
            sum += reflectance[i];
        }
        EXPECT_NEAR(sum, 1.0, 1e-9) << wavelength_nm(i);
    }
}

TEST(RgbBasis, HasTheColoursOfThePrimaries)
{
    const ColourWeights weights = reflectance_weights(cie_illuminant("D65"), ObserverId::cie1931,
                                                      colour_space("lin_rec709_scene"));
    for (std::size_t primary = 0; primary < 3; ++primary) {
        const Vec3 rgb = weights.apply(rgb_basis()[primary]);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], c == primary ? 1.0 : 0.0, 2e-6);
    }
}

}  // namespace
}  // namespace nacre::spectral
