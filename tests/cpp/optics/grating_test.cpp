// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/grating.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "stacks.h"
#include "support/expect.h"

namespace nacre::optics {
namespace {

using std::numbers::pi;

double dot(const Direction& a, const Direction& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction combine(double a, const Direction& u, double b, const Direction& v)
{
    return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}
Direction unit(const Direction& v)
{
    return combine(1.0 / std::sqrt(dot(v, v)), v, 0.0, v);
}
double distance(const Direction& a, const Direction& b)
{
    const Direction d = combine(1.0, a, -1.0, b);
    return std::sqrt(dot(d, d));
}

Grating cd(GratingProfile profile = {ProfileKind::rectangular, 2.0, 0.3})
{
    return {.pitch_nm = 1600.0,
            .grating_vector = {1.0, 0.0, 0.0},
            .normal = {0.0, 0.0, 1.0},
            .profile = profile};
}

rc::Gen<Direction> direction()
{
    return rc::gen::suchThat(
        rc::gen::apply(
            [](double x, double y, double z) {
                return Direction{x, y, z};
            },
            test::between(-1.0, 1.0), test::between(-1.0, 1.0), test::between(-1.0, 1.0)),
        [](const Direction& v) { return dot(v, v) > 0.01; });
}

// sinθ_m = sinθ_i + m λ/d in the plane across the grooves.
TEST(Grating, ClassicalMountingHasTheTextbookAngles)
{
    const double sine = 0.3, nm = 550.0;
    const auto orders = grating_orders(cd(), {sine, 0.0, -std::sqrt(1 - sine * sine)}, nm, -4, 2);
    ASSERT_EQ(orders.size(), 7U);
    for (const DiffractedOrder& order : orders) {
        const double out = sine + order.order * nm / 1600.0;
        if (std::abs(out) >= 1.0) {
            EXPECT_FALSE(order.direction);
            continue;
        }
        ASSERT_TRUE(order.direction) << order.order;
        EXPECT_NEAR((*order.direction)[0], out, 1e-15);
        EXPECT_NEAR((*order.direction)[1], 0.0, 1e-15);
        EXPECT_NEAR((*order.direction)[2], std::sqrt(1.0 - out * out), 1e-15);
    }
    EXPECT_TRUE(orders[1].direction);   // -3: 0.3 - 1.03 = -0.73
    EXPECT_FALSE(orders[0].direction);  // -4: -1.075
}

// Light along the grooves leaves on a cone about them.
TEST(Grating, ConicalMountingKeepsTheComponentAlongTheGrooves)
{
    const Direction k_in = unit({0.0, 0.6, -0.8});
    for (const DiffractedOrder& order : grating_orders(cd(), k_in, 550.0, -2, 2)) {
        ASSERT_TRUE(order.direction);
        EXPECT_NEAR((*order.direction)[1], 0.6, 1e-15);
        EXPECT_NEAR((*order.direction)[0], order.order * 550.0 / 1600.0, 1e-15);
    }
}

RC_GTEST_PROP(Grating, AnyMountingObeysTheGratingEquation, ())
{
    const Direction normal = *direction(), across = *direction();
    const Direction n = unit(normal), flat = combine(1.0, across, -dot(across, n), n);
    RC_PRE(dot(flat, flat) > 1e-3 * dot(across, across));
    const Direction k_in = *rc::gen::suchThat(
        direction(), [&](const Direction& k) { return dot(unit(k), n) < -1e-3; });
    Grating grating = cd();
    grating.normal = normal;
    grating.grating_vector = across;
    grating.pitch_nm = *test::between(300.0, 5000.0);
    const double nm = *test::between(360.0, 830.0);

    const Direction k = unit(k_in), g = unit(flat);
    for (const DiffractedOrder& order : grating_orders(grating, k_in, nm, -8, 8)) {
        const Direction in = combine(1.0, k, -dot(k, n), n);
        const Direction wanted = combine(1.0, in, order.order * nm / grating.pitch_nm, g);
        if (!order.direction) {
            RC_ASSERT(dot(wanted, wanted) > 1.0 - 1e-12);
            RC_ASSERT(order.efficiency == 0.0);
            continue;
        }
        const Direction& out = *order.direction;
        RC_ASSERT(std::abs(dot(out, out) - 1.0) < 1e-13);
        RC_ASSERT(dot(out, n) > 0.0);
        RC_ASSERT(distance(combine(1.0, out, -dot(out, n), n), wanted) < 1e-13);
        RC_ASSERT(order.efficiency >= 0.0 && order.efficiency <= 1.0 + 1e-14);
        if (order.order == 0)
            RC_ASSERT(distance(out, combine(1.0, k, -2.0 * dot(k, n), n)) < 1e-13);
    }
}

TEST(Grating, LengthsOfTheVectorsDoNotCount)
{
    const Direction k_in{0.2, 0.1, -0.9};
    const Grating plain = cd();
    Grating scaled = plain;
    scaled.normal = {0.0, 0.0, 1e-5};
    scaled.grating_vector = {7.0, 0.0, 100.0};  // only its tangential part counts
    const auto a = grating_orders(plain, k_in, 550.0, -2, 2);
    const auto b = grating_orders(scaled, combine(1e6, k_in, 0.0, k_in), 550.0, -2, 2);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT(distance(*a[i].direction, *b[i].direction), 1e-14);
        EXPECT_NEAR(a[i].efficiency, b[i].efficiency, 1e-14);
    }
}

// |∫ exp(iφ(x)) exp(−2πimx) dx|² over one period, midpoint rule.
double fourier_efficiency(const GratingProfile& profile, int m)
{
    constexpr int kSteps = 1 << 13;
    std::complex<double> sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double x = (i + 0.5) / kSteps;
        double height = x;  // blazed
        if (profile.kind == ProfileKind::sinusoidal) height = 0.5 * std::sin(2.0 * pi * x);
        if (profile.kind == ProfileKind::rectangular) height = x < profile.duty ? 1.0 : 0.0;
        sum += std::polar(1.0, profile.phase_rad * height - 2.0 * pi * m * x);
    }
    return std::norm(sum / double{kSteps});
}

TEST(Grating, EfficienciesAreFourierCoefficients)
{
    for (const ProfileKind kind :
         {ProfileKind::sinusoidal, ProfileKind::rectangular, ProfileKind::blazed}) {
        for (const double phase : {0.0, 0.7, pi, 2.0 * pi, 11.0, -4.0}) {
            for (const double duty : {0.25, 0.5, 0.8125}) {  // edges between two midpoints
                const GratingProfile profile{kind, phase, duty};
                for (int m = -7; m <= 7; ++m)
                    EXPECT_NEAR(scalar_efficiency(profile, m), fourier_efficiency(profile, m), 3e-6)
                        << "profile " << static_cast<int>(kind) << ", phase " << phase << ", order "
                        << m;
            }
        }
    }
}

// J_0(2.404825557695773) = 0: the mirror order goes out at twice that peak-to-valley phase.
TEST(Grating, SinusoidFollowsBessel)
{
    const GratingProfile dark{ProfileKind::sinusoidal, 2.0 * 2.404825557695773, 0.5};
    EXPECT_LT(scalar_efficiency(dark, 0), 1e-30);
    for (const int m : {1, 2, 5, 30}) {
        for (const double phase : {0.5, 8.0, 100.0}) {
            const double expected = std::cyl_bessel_j(m, 0.5 * phase);
            const GratingProfile profile{ProfileKind::sinusoidal, phase, 0.5};
            EXPECT_NEAR(scalar_efficiency(profile, m), expected * expected, 1e-14);
            EXPECT_NEAR(scalar_efficiency(profile, -m), expected * expected, 1e-14);
        }
    }
}

// Goodman, Introduction to Fourier Optics: at phase π and duty 1/2, 4/(π²m²) in the odd orders.
TEST(Grating, HalfWaveRectangleHasClosedForm)
{
    const GratingProfile profile{ProfileKind::rectangular, pi, 0.5};
    EXPECT_NEAR(scalar_efficiency(profile, 0), 0.0, 1e-15);
    for (const int m : {1, 3, -5})
        EXPECT_NEAR(scalar_efficiency(profile, m), 4.0 / (pi * pi * m * m), 1e-15);
    for (const int m : {2, -4}) EXPECT_NEAR(scalar_efficiency(profile, m), 0.0, 1e-15);
}

TEST(Grating, BlazeSendsAllIntoItsOrder)
{
    for (const int blaze : {-2, 0, 1, 3}) {
        const GratingProfile profile{ProfileKind::blazed, 2.0 * pi * blaze, 0.5};
        for (int m = -5; m <= 5; ++m)
            EXPECT_NEAR(scalar_efficiency(profile, m), m == blaze ? 1.0 : 0.0, 1e-15);
    }
}

TEST(Grating, FlatProfilesAreMirrors)
{
    for (const GratingProfile profile : {GratingProfile{ProfileKind::sinusoidal, 0.0, 0.5},
                                         GratingProfile{ProfileKind::blazed, 0.0, 0.5},
                                         GratingProfile{ProfileKind::rectangular, 2.0, 0.0},
                                         GratingProfile{ProfileKind::rectangular, 2.0, 1.0}})
        for (int m = -3; m <= 3; ++m)
            EXPECT_NEAR(scalar_efficiency(profile, m), m == 0 ? 1.0 : 0.0, 1e-15);
}

TEST(Grating, AllOrdersTogetherKeepTheEnergy)
{
    double sinusoid = 0.0;
    for (int m = -60; m <= 60; ++m)
        sinusoid += scalar_efficiency({ProfileKind::sinusoidal, 30.0, 0.5}, m);
    EXPECT_NEAR(sinusoid, 1.0, 1e-14);
    for (const ProfileKind kind :
         {ProfileKind::sinusoidal, ProfileKind::rectangular, ProfileKind::blazed}) {
        for (const Direction& k_in : {Direction{0.0, 0.0, -1.0}, Direction{0.9, 0.3, -0.2}}) {
            double sum = 0.0;
            for (const auto& order : grating_orders(cd({kind, 4.0, 0.3}), k_in, 633.0, -20, 20))
                sum += order.efficiency;
            EXPECT_NEAR(sum, 1.0, 1e-14);
        }
    }
}

// Blu-ray at normal incidence: λ > d, nothing but the mirror order is left.
TEST(Grating, FineGratingsAreMirrorsAtNormalIncidence)
{
    Grating fine = cd();
    fine.pitch_nm = 320.0;
    for (const auto& order : grating_orders(fine, {0.0, 0.0, -1.0}, 450.0, -2, 2)) {
        EXPECT_EQ(order.direction.has_value(), order.order == 0);
        EXPECT_NEAR(order.efficiency, order.order == 0 ? 1.0 : 0.0, 1e-15);
    }
    const auto grazing = grating_orders(fine, unit({1.0, 0.0, -0.1}), 450.0, -1, -1);
    EXPECT_TRUE(grazing[0].direction);  // λ < d (1 + sinθ)
}

// Mirror order at efficiency 0 and every other order evanescent: the light has one way left.
TEST(Grating, TheMirrorTakesAllWhereNoOtherOrderIsLeft)
{
    Grating fine = cd({ProfileKind::blazed, 2.0 * pi, 0.5});
    fine.pitch_nm = 320.0;
    const auto orders = grating_orders(fine, {0.0, 0.0, -1.0}, 450.0, 0, 0);
    EXPECT_EQ(orders[0].efficiency, 1.0);
}

TEST(Grating, RefusesWhatMakesNoSense)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Direction down{0.0, 0.0, -1.0};
    const auto with = [&](auto&& change) {
        Grating grating = cd();
        change(grating);
        return nacre::test::input_error_of(
            [&] { static_cast<void>(grating_orders(grating, down, 550.0, -1, 1)); });
    };
    EXPECT_EQ(with([](Grating& g) { g.pitch_nm = 0.0; }), "pitch_nm: must be finite and > 0");
    EXPECT_EQ(with([&](Grating& g) { g.pitch_nm = nan; }), "pitch_nm: must be finite and > 0");
    EXPECT_EQ(with([](Grating& g) { g.pitch_nm = 1e9; }),
              "pitch_nm: must be at most 10000 wavelengths");
    EXPECT_EQ(with([](Grating& g) { g.normal = {}; }), "normal: must be finite and not zero");
    EXPECT_EQ(with([&](Grating& g) { g.grating_vector[0] = nan; }),
              "grating_vector: must be finite and not zero");
    EXPECT_EQ(with([](Grating& g) {
                  g.grating_vector = {0.0, 0.0, 2.0};
              }),
              "grating_vector: must not be parallel to the normal");
    EXPECT_EQ(with([](Grating& g) { g.profile.duty = 1.5; }), "profile.duty: must be in [0, 1]");
    EXPECT_EQ(with([&](Grating& g) { g.profile.duty = nan; }), "profile.duty: must be in [0, 1]");
    EXPECT_EQ(with([](Grating& g) { g.profile.phase_rad = 1e4; }),
              "profile.phase_rad: must be within ±1000 rad");

    const auto lit = [](const Direction& k_in, double nm, int first, int last) {
        return nacre::test::input_error_of(
            [&] { static_cast<void>(grating_orders(cd(), k_in, nm, first, last)); });
    };
    EXPECT_EQ(lit({0.0, 0.0, 1.0}, 550.0, 0, 0),
              "k_in: must point towards the surface (k_in · normal < 0)");
    EXPECT_EQ(lit({1.0, 0.0, 0.0}, 550.0, 0, 0),
              "k_in: must point towards the surface (k_in · normal < 0)");
    EXPECT_EQ(lit({}, 550.0, 0, 0), "k_in: must be finite and not zero");
    EXPECT_EQ(lit(down, -1.0, 0, 0), "wavelength_nm: must be finite and > 0");
    EXPECT_EQ(lit(down, 550.0, 1, 0), "orders: must ascend and stay within ±100000");
    EXPECT_EQ(lit(down, 550.0, 0, 100001), "orders: must ascend and stay within ±100000");
}

TEST(Grating, ReportsAllProblemsAtOnce)
{
    Grating grating = cd();
    grating.pitch_nm = -1.0;
    grating.profile.duty = 2.0;
    EXPECT_INPUT_ERROR(static_cast<void>(grating_orders(grating, {0, 0, -1}, 0.0, 0, 0)),
                       "pitch_nm");
    EXPECT_INPUT_ERROR(static_cast<void>(grating_orders(grating, {0, 0, -1}, 0.0, 0, 0)),
                       "profile.duty");
    EXPECT_INPUT_ERROR(static_cast<void>(grating_orders(grating, {0, 0, -1}, 0.0, 0, 0)),
                       "wavelength_nm");
}

}  // namespace
}  // namespace nacre::optics
