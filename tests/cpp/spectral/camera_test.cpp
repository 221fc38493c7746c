// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/camera.h"

#include "support/expect.h"

namespace nacre::spectral {
namespace {

// Darrodi et al. 2015, as colour-science 0.4.6 has it.
TEST(Camera, HoldsTheMeasuredTable)
{
    const Camera nikon = camera("nikon-d5100");
    EXPECT_EQ(nikon.name, "Nikon D5100");
    EXPECT_EQ(nikon.at(380.0), (Vec3{0.00156384, 0.000115, 0.00180956}));
    EXPECT_NEAR(nikon.at(382.5)[1], 0.5 * (0.000115 + 0.00152114), 1e-12);
    EXPECT_EQ(camera("sigma-sd1-merrill").at(420.0), (Vec3{0.0740791, 0.0252718, 0.396904}));
}

TEST(Camera, SeesNothingBeyondItsSamples)
{
    for (const std::string& key : camera_keys()) {
        EXPECT_EQ(camera(key).at(360.0), (Vec3{0.0, 0.0, 0.0})) << key;
        EXPECT_EQ(camera(key).at(800.0), (Vec3{0.0, 0.0, 0.0})) << key;
        for (int nm = 400; nm <= 680; ++nm)
            for (const double value : camera(key).at(nm)) EXPECT_GE(value, 0.0) << key << nm;
    }
}

TEST(Camera, UnknownOnesAreNamedWithThoseThatAreThere)
{
    EXPECT_INPUT_ERROR(static_cast<void>(camera("brownie")),
                       "camera: must be one of nikon-d5100, sigma-sd1-merrill (got 'brownie')");
}

}  // namespace
}  // namespace nacre::spectral
