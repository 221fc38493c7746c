// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/wavelengths.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

TEST(Wavelengths, RunFrom360To830InSteps)
{
    EXPECT_EQ(kWavelengths, 471u);
    EXPECT_EQ(wavelength_nm(0), 360.0);
    EXPECT_EQ(wavelength_nm(200), 560.0);
    EXPECT_EQ(wavelength_nm(kWavelengths - 1), 830.0);
}

}  // namespace
}  // namespace nacre::spectral
