// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/gratings.h"
#include "refusal.h"
#include "support/not_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using nacre::test::error;

using nacre::test::kNan;

nacre_grating disc()
{
    return {.pitch_nm = 1600.0,
            .wavelength_nm = 550.0,
            .grating_vector = {1.0, 0.0, 0.0},
            .normal = {0.0, 0.0, 1.0},
            .k_in = {0.0, 0.0, -1.0},
            .profile = "rectangular",
            .phase_rad = M_PI,
            .duty = 0.5};
}

TEST(CapiGrating, OrdersOfADisc)
{
    const nacre_grating grating = disc();
    double directions[9][3], efficiencies[9];
    ASSERT_EQ(nacre_grating_orders(&grating, -4, 4, directions[0], efficiencies), NACRE_OK);
    for (int i = 0; i < 9; ++i) {
        const double across = (i - 4) * 550.0 / 1600.0;
        const bool propagates = std::abs(across) < 1.0;
        EXPECT_NEAR(directions[i][0], propagates ? across : 0.0, 1e-15);
        EXPECT_NEAR(directions[i][2], propagates ? std::sqrt(1 - across * across) : 0.0, 1e-15);
    }
    EXPECT_NEAR(efficiencies[3], efficiencies[5], 1e-15);
    EXPECT_GT(efficiencies[5], 0.4);
    EXPECT_EQ(efficiencies[8], 0.0);
    EXPECT_EQ(directions[8][2], 0.0);
}

TEST(CapiGrating, RefusesBadInputAndLeavesTheOutputsAlone)
{
    double directions[9] = {-7.0}, efficiencies[3] = {-7.0};
    const auto with = [&](auto&& change) {
        nacre_grating grating = disc();
        change(grating);
        const std::string message =
            error(nacre_grating_orders(&grating, -1, 1, directions, efficiencies));
        EXPECT_EQ(directions[0], -7.0);
        EXPECT_EQ(efficiencies[0], -7.0);
        return message;
    };
    EXPECT_EQ(with([](nacre_grating& g) { g.pitch_nm = -1.0; }),
              "pitch_nm: must be finite and > 0");
    EXPECT_EQ(with([](nacre_grating& g) { g.wavelength_nm = kNan; }),
              "wavelength_nm: must be finite and > 0");
    EXPECT_EQ(with([](nacre_grating& g) { g.k_in[2] = 1.0; }),
              "k_in: must point towards the surface (k_in · normal < 0)");
    EXPECT_EQ(with([](nacre_grating& g) { g.profile = "square"; }),
              "profile.kind: must be sinusoidal, rectangular or blazed (got square)");
    EXPECT_EQ(with([](nacre_grating& g) { g.profile = nullptr; }),
              "profile.kind: must not be null");
    EXPECT_EQ(with([](nacre_grating& g) { g.duty = 2.0; }), "profile.duty: must be in [0, 1]");

    const nacre_grating grating = disc();
    EXPECT_EQ(error(nacre_grating_orders(nullptr, 0, 0, directions, efficiencies)),
              "grating: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 0, 0, nullptr, efficiencies)),
              "directions: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 0, 0, directions, nullptr)),
              "efficiencies: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 1, 0, directions, efficiencies)),
              "orders: must ascend and stay within ±100000");
}

}  // namespace
