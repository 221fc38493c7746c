// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/microsurface_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/optics/microfacet.h"

namespace nacre::optics {
namespace {

constexpr std::uint64_t kPaths = 200'000;

std::array<double, 3> view_at(double cos_theta)
{
    return {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta};
}

TEST(MicrosurfaceWalk, OneBounceIsTheSingleScatteringLobe)
{
    for (const double alpha : {0.1, 0.4, 0.8})
        for (const double mu : {0.15, 0.5, 0.95}) {
            double once = 0.0, cosine = 0.0;
            walk_microsurface({view_at(mu), {alpha, alpha}, kPaths},
                              [&](std::span<const double> cosines, const auto&) {
                                  if (cosines.size() != 1) return;
                                  once += 1.0;
                                  cosine += cosines[0];
                              });
            std::vector<double> weights(257);
            const double albedo = facet_weights(mu, alpha, weights);
            double mean = 0.0;
            for (std::size_t i = 0; i < weights.size(); ++i)
                mean += weights[i] * static_cast<double>(i) / 256.0;
            // Four standard deviations of so many paths are 4.5e-3 at most.
            EXPECT_NEAR(once / kPaths, albedo, 4.5e-3) << alpha << ' ' << mu;
            EXPECT_NEAR(cosine / once, mean, 4.5e-3) << alpha << ' ' << mu;
        }
}

TEST(MicrosurfaceWalk, MirrorsLoseNoLight)
{
    std::uint64_t left = 0;
    double up = 1.0;
    walk_microsurface({view_at(0.3), {0.9, 0.4}, kPaths, 7, 64},
                      [&](std::span<const double> cosines, const std::array<double, 3>& out) {
                          ++left;
                          up = std::min(up, out[2]);
                          EXPECT_GE(cosines.size(), 1u);
                      });
    EXPECT_GT(static_cast<double>(left), 0.9999 * kPaths);
    EXPECT_GT(up, 0.0);
}

TEST(MicrosurfaceWalk, PathsAreTheSameEveryTime)
{
    const auto sum = [] {
        double total = 0.0;
        walk_microsurface({view_at(0.6), {0.5, 0.5}, 1000, 3},
                          [&](auto cosines, const auto& out) { total += cosines[0] + out[0]; });
        return total;
    };
    EXPECT_EQ(sum(), sum());
}

}  // namespace
}  // namespace nacre::optics
