// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/textures/spectral_channels.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

TEST(SpectralChannels, NamesOfTheLayout)
{
    EXPECT_EQ(spectral_channel_name({SpectrumKind::reflectance, 550.0}), "T.550,000000nm");
    EXPECT_EQ(spectral_channel_name({SpectrumKind::emission, 589.3}), "S0.589,300000nm");
    const auto nm = [](std::string_view name) {
        const auto channel = parse_spectral_channel(name);
        return channel ? channel->wavelength_nm : -1.0;
    };
    EXPECT_EQ(nm("T.550,000000nm"), 550.0);
    EXPECT_EQ(nm("T.324,000000nm"), 324.0);
    EXPECT_DOUBLE_EQ(nm("S0.5,5e2nm"), 550.0);
    EXPECT_DOUBLE_EQ(nm("S0.0,55um"), 550.0);
    EXPECT_NEAR(nm("S0.545THz"), 550.0779, 1e-4);
    EXPECT_NEAR(nm("S0.0,000545EHz"), 550.0779, 1e-4);
    EXPECT_EQ(parse_spectral_channel("S0.550nm")->kind, SpectrumKind::emission);
    EXPECT_EQ(parse_spectral_channel("T.550nm")->kind, SpectrumKind::reflectance);
    for (const char* name : {"R", "S1.550nm", "T.", "T.nm", "T.550", "T.550xm", "T.-550nm", "T.0nm",
                             "T.nannm", "T.1e999nm", "S0.0Hz", "T550nm", "T.550EnHz"})
        EXPECT_EQ(nm(name), -1.0) << name;
}

}  // namespace
}  // namespace nacre::spectral
