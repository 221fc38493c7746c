// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/microfacet.h"
#include "nacre/optics/smith.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace nacre::optics {
namespace {

/// D(h) of GGX.
double distribution(double cos_facet, double alpha)
{
    const double c2 = cos_facet * cos_facet, a2 = alpha * alpha;
    const double root = c2 * (a2 - 1.0) + 1.0;
    return a2 / (std::numbers::pi * root * root);
}

struct Reflected {
    double mirror = 0.0, tinted = 0.0;
};

/// The textbook integral ∫ D G2 /(4 cosθ_i cosθ_o) cosθ_o over outgoing directions, no sampling of
/// visible normals: albedo of mirrors, and of facets that reflect `R(cosine)`.
template <class R>
Reflected integrate_lobe(double mu, double alpha, R&& reflectance)
{
    constexpr int kPolar = 1500, kAzimuths = 720;
    const double sine = std::sqrt(1.0 - mu * mu);
    Reflected sum;
    for (int i = 0; i < kPolar; ++i) {
        const double z = (i + 0.5) / kPolar, across = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kAzimuths; ++j) {
            const double phi = std::numbers::pi * (j + 0.5) / kAzimuths;
            const double x = across * std::cos(phi) + sine, y = across * std::sin(phi), up = z + mu;
            const double length = std::sqrt(x * x + y * y + up * up);
            const double G2 = 1.0 / (1.0 + smith_lambda(mu, alpha) + smith_lambda(z, alpha));
            const double lobe = distribution(up / length, alpha) * G2 / (4.0 * mu);
            sum.mirror += lobe;
            sum.tinted += lobe * reflectance((x * sine + up * mu) / length);
        }
    }
    const double step = 2.0 * std::numbers::pi / (kPolar * kAzimuths);
    return {sum.mirror * step, sum.tinted * step};
}

TEST(Microfacet, WeightsAreThoseOfTheLobe)
{
    const auto film = [](double c) { return 0.4 + 0.3 * std::cos(9.0 * c) + 0.3 * c; };
    std::vector<double> weights(201);
    for (const double alpha : {0.15, 0.3, 0.8})
        for (const double mu : {0.2, 0.6, 0.97}) {
            const Reflected exact = integrate_lobe(mu, alpha, film);
            const double albedo = facet_weights(mu, alpha, weights);
            double mean = 0.0;
            for (std::size_t i = 0; i < weights.size(); ++i)
                mean += weights[i] * film(static_cast<double>(i) / 200.0);
            EXPECT_NEAR(albedo, exact.mirror, 3e-4) << alpha << ' ' << mu;
            EXPECT_NEAR(mean, exact.tinted / exact.mirror, 3e-4) << alpha << ' ' << mu;
            EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1.0, 1e-12);
        }
}

TEST(Microfacet, NearlySmoothIsTheMacroscopicAngle)
{
    std::vector<double> weights(101);
    EXPECT_NEAR(facet_weights(0.7, 1e-4, weights), 1.0, 1e-4);
    EXPECT_NEAR(weights[70], 1.0, 0.02);
    EXPECT_NEAR(ggx_albedo(0.5, 1e-4), 1.0, 1e-4);
}

}  // namespace
}  // namespace nacre::optics
