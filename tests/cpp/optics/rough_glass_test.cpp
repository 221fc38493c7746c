// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/rough_glass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "nacre/optics/fresnel.h"
#include "nacre/optics/microfacet.h"
#include "nacre/optics/smith.h"

namespace nacre::optics {
namespace {

double fresnel(double cosine, double eta)
{
    const Complex refracted = forward_cosine(1.0, eta, cosine);
    const FresnelAmplitudes a = fresnel_amplitudes(1.0, eta, cosine, refracted);
    return 0.5 * (std::norm(a.r_s) + std::norm(a.r_p));
}

struct Lobes {
    double mirror = 0.0, window = 0.0, clear_mirror = 0.0, clear_window = 0.0;
};

/// Walter et al. 2007, equations 20 and 21 with Smith's G of correlated heights, summed over
/// outgoing directions; no sampling of visible normals. `eta` is n_o / n_i.
Lobes integrate(double mu, double alpha, double eta)
{
    constexpr int kPolar = 1200, kAzimuths = 600;
    constexpr double kStep = 2.0 * std::numbers::pi / (kPolar * kAzimuths);
    const double sine = std::sqrt(1.0 - mu * mu), a2 = alpha * alpha;
    Lobes sum;
    for (int i = 0; i < kPolar; ++i)
        for (int j = 0; j < kAzimuths; ++j) {
            const double z = (i + 0.5) / kPolar, across = std::sqrt(1.0 - z * z);
            const double phi = std::numbers::pi * (j + 0.5) / kAzimuths;
            const double x = across * std::cos(phi), y = across * std::sin(phi);
            const double G = 1.0 / (1.0 + smith_lambda(mu, alpha) + smith_lambda(z, alpha));
            const auto D = [a2](double up) {
                const double root = up * up * (a2 - 1.0) + 1.0;
                return a2 / (std::numbers::pi * root * root);
            };
            const double mirror = std::hypot(x + sine, y, z + mu);
            const double mirrored = D((z + mu) / mirror) * G / (4.0 * mu) * kStep;
            sum.mirror += mirrored;
            sum.clear_mirror += fresnel((x * sine + z * mu + 1.0) / mirror, eta) * mirrored;

            // The outgoing direction is (x, y, −z); the facet lies along −(i + η o), turned up.
            double hx = -(sine + eta * x), hy = -eta * y, hz = -(mu - eta * z);
            const double length = std::copysign(std::hypot(hx, hy, hz), hz);
            hx /= length, hy /= length, hz /= length;
            const double in = hx * sine + hz * mu, out = hx * x + hy * y - hz * z;
            if (in <= 0.0 || out >= 0.0) continue;
            const double root = in + eta * out;
            const double refracted = -in * out * eta * eta * D(hz) * G / (mu * root * root) * kStep;
            sum.window += refracted;
            sum.clear_window += (1.0 - fresnel(in, eta)) * refracted;
        }
    return sum;
}

TEST(RoughGlass, AlbedosAreThoseOfTheLobes)
{
    for (const bool inside : {false, true})
        for (const double alpha : {0.3, 0.8})
            for (const double mu : {0.3, 0.8}) {
                const Lobes exact = integrate(mu, alpha, inside ? 1.0 / 1.5 : 1.5);
                const GlassFacets found = glass_facets(
                    {.cos_theta = mu, .alpha = alpha, .index = 1.5, .inside = inside}, 65);
                const auto where = ::testing::Message() << alpha << ' ' << mu << ' ' << inside;
                EXPECT_NEAR(found.mirror, exact.mirror, 1e-3) << where;
                EXPECT_NEAR(found.window, exact.window, 1e-3) << where;
                EXPECT_NEAR(found.clear_mirror, exact.clear_mirror, 1e-3) << where;
                EXPECT_NEAR(found.clear_window, exact.clear_window, 1e-3) << where;
            }
}

/// Over all directions as much passes either way, for each of the n² times more that there are
/// inside: the étendue of Walter et al. 2007, section 4.
TEST(RoughGlass, PassesAsMuchBothWays)
{
    constexpr int kDirections = 64;
    constexpr double kIndex = 1.7;
    for (const double alpha : {0.1, 0.5, 1.0}) {
        double in = 0.0, out = 0.0;
        for (int i = 0; i < kDirections; ++i) {
            const double mu = (i + 0.5) / kDirections;
            const auto passed = [&](bool inside) {
                return 2.0 * mu / kDirections *
                       glass_facets(
                           {.cos_theta = mu, .alpha = alpha, .index = kIndex, .inside = inside}, 2)
                           .clear_window;
            };
            in += passed(false);
            out += passed(true);
        }
        EXPECT_NEAR(in, kIndex * kIndex * out, 2e-3) << alpha;
    }
}

TEST(RoughGlass, MeansAreThoseOfTheFacets)
{
    // Linear in the cosine, so that columns lose nothing: the means of F and of a ramp.
    const GlassFacets view =
        glass_facets({.cos_theta = 0.6, .alpha = 0.5, .index = 1.5, .inside = true}, 2001);
    const auto mean = [](const std::vector<double>& weights, auto&& value) {
        double sum = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i)
            sum += weights[i] * value(static_cast<double>(i) / 2000.0);
        return sum;
    };
    const auto F = [](double c) { return fresnel(c, 1.5); };
    EXPECT_NEAR(mean(view.met, [](double) { return 1.0; }), 1.0, 1e-12);
    EXPECT_NEAR(mean(view.reflected, F), view.clear_mirror, 1e-3);
    EXPECT_NEAR(mean(view.passed, [&](double c) { return 1.0 - F(c); }), view.clear_window, 1e-3);
    EXPECT_NEAR(mean(view.reflected, [](double) { return 1.0; }), view.mirror, 1e-12);
    EXPECT_NEAR(mean(view.passed, [](double) { return 1.0; }), view.window, 1e-12);
}

TEST(RoughGlass, SmoothGlassIsOneFacet)
{
    const GlassFacets outside = glass_facets({.cos_theta = 1.0, .alpha = 0.0, .index = 1.5}, 5);
    EXPECT_NEAR(outside.clear_mirror, 0.04, 1e-12);  // ((n − 1)/(n + 1))²
    EXPECT_NEAR(outside.clear_window, 0.96, 1e-12);
    EXPECT_DOUBLE_EQ(outside.met[4], 1.0);
    // Inside of n = 1.5 all is reflected beyond 41.8 degrees: cosθ = 0.745.
    const auto inside = [](double cos_theta) {
        return glass_facets({.cos_theta = cos_theta, .alpha = 0.0, .index = 1.5, .inside = true},
                            5);
    };
    EXPECT_EQ(inside(0.74).window, 0.0);
    EXPECT_EQ(inside(0.74).clear_mirror, 1.0);
    EXPECT_DOUBLE_EQ(inside(0.74).met[0], 1.0);
    EXPECT_GT(inside(0.75).clear_window, 0.1);
}

}  // namespace
}  // namespace nacre::optics
