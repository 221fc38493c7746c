// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/smith.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::optics {
namespace {

// Walter et al. 2007, equation 34: G1 = 2 / (1 + √(1 + α² tan²θ)) = 1 / (1 + Λ).
TEST(SmithLambda, IsThatOfGgx)
{
    for (const double alpha : {0.1, 0.5, 1.0})
        for (const double cos_theta : {0.05, 0.5, 1.0}) {
            const double tan2 = 1.0 / (cos_theta * cos_theta) - 1.0;
            const double G1 = 2.0 / (1.0 + std::sqrt(1.0 + alpha * alpha * tan2));
            EXPECT_NEAR(1.0 / (1.0 + smith_lambda(cos_theta, alpha)), G1, 1e-14);
        }
    EXPECT_EQ(smith_lambda(1.0, 0.5), 0.0);
    EXPECT_EQ(smith_lambda(0.3, 0.0), 0.0);
    EXPECT_TRUE(std::isfinite(smith_lambda(0.0, 1.0)));
}

}  // namespace
}  // namespace nacre::optics
