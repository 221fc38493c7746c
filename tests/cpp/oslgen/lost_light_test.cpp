// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/lost_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nacre/optics/microfacet.h"

namespace nacre::oslgen {
namespace {

double fitted_albedo(double cos_theta, double alpha)
{
    const double u = std::log(alpha), v = std::log(cos_theta);
    double sum = 0.0;
    for (std::size_t i = kLostLight.size(); i-- > 0;)
        sum = sum * u + kLostLight[i][0] + v * (kLostLight[i][1] + v * kLostLight[i][2]);
    return 1.0 / (1.0 + std::exp(sum));
}

TEST(LostLight, MeetsTheAlbedoOfMirrors)
{
    constexpr int kSteps = 40;
    std::vector<double> weights(2);
    double worst = 0.0;
    for (int i = 0; i <= kSteps; ++i)
        for (int j = 0; j <= kSteps; ++j) {
            const double alpha = std::lerp(kLeastLostAlpha, 1.0, static_cast<double>(i) / kSteps);
            const double cos_theta =
                std::lerp(kLeastLostCosine, 1.0, static_cast<double>(j) / kSteps);
            const double exact = optics::facet_weights(cos_theta, alpha, weights);
            worst = std::max(worst, std::abs(fitted_albedo(cos_theta, alpha) - exact));
        }
    EXPECT_LT(worst, 0.014);
}

}  // namespace
}  // namespace nacre::oslgen
