// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/fresnel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "optics/light.h"
#include "stacks.h"
#include "support/expect.h"

namespace nacre::optics {
namespace {

constexpr Complex kGlass{1.5, 0.0}, kAir{1.0, 0.0};
constexpr Complex kI{0.0, 1.0};

FresnelAmplitudes interface(Complex n_i, Complex n_t, Complex cos_i)
{
    return fresnel_amplitudes(n_i, n_t, cos_i, forward_cosine(n_i, n_t, cos_i));
}

TEST(Fresnel, NormalIncidenceHasClosedForm)
{
    for (const Complex n : {kGlass, kGold, Complex(2.4, 1e-3)}) {
        const FresnelAmplitudes a = interface(kAir, n, 1.0);
        EXPECT_COMPLEX_NEAR(a.r_s, (1.0 - n) / (1.0 + n), 1e-15);
        EXPECT_COMPLEX_NEAR(a.r_p, -a.r_s, 1e-15);  // Verdet's sign
        EXPECT_COMPLEX_NEAR(a.t_s, 2.0 / (1.0 + n), 1e-15);
        EXPECT_COMPLEX_NEAR(a.t_p, a.t_s, 1e-15);
    }
}

// tanθ = n: p is not reflected, and s has r = −(n² − 1)/(n² + 1).
TEST(Fresnel, BrewsterAngleReflectsOnlyS)
{
    for (const double n : {1.33, 1.5, 2.4}) {
        const FresnelAmplitudes a = interface(1.0, n, 1.0 / std::hypot(1.0, n));
        EXPECT_COMPLEX_NEAR(a.r_p, 0.0, 1e-15);
        EXPECT_COMPLEX_NEAR(a.r_s, -(n * n - 1.0) / (n * n + 1.0), 1e-15);
        EXPECT_COMPLEX_NEAR(a.t_p, 1.0 / n, 1e-15);
    }
}

// With q_t = iγ, γ² = n_i² sin²θ − n_t²: r_s = e^{−2i·atan(γ/n_i cosθ)} and
// r_p = e^{−2i·atan(n_i γ/n_t² cosθ)} (Born & Wolf, section 1.5.4; conjugate there is the sign of
// time).
TEST(Fresnel, TotalReflectionKeepsThePowerAndShiftsThePhase)
{
    constexpr double n = 1.5;
    for (const double degrees : {41.9, 45.0, 60.0, 89.0, 89.99}) {
        const double cosine = std::cos(degrees * M_PI / 180), sine = std::sin(degrees * M_PI / 180);
        const double gamma = std::sqrt(n * n * sine * sine - 1.0);
        const FresnelAmplitudes a = interface(n, 1.0, cosine);
        EXPECT_NEAR(std::abs(a.r_s), 1.0, 1e-15);
        EXPECT_NEAR(std::abs(a.r_p), 1.0, 1e-15);
        EXPECT_COMPLEX_NEAR(a.r_s, std::exp(-2.0 * kI * std::atan2(gamma, n * cosine)), 1e-12);
        EXPECT_COMPLEX_NEAR(a.r_p, std::exp(-2.0 * kI * std::atan2(n * gamma, cosine)), 1e-12);
    }
}

// n_i sinθ = n_t exactly: 1.25² (1 − 0.8²) = 0.75². A rounding ε of cosθ moves r by √ε.
TEST(Fresnel, CriticalAngleReflectsEverything)
{
    EXPECT_COMPLEX_NEAR(forward_cosine(1.25, 0.75, 0.8), 0.0, 1e-7);
    const FresnelAmplitudes a = fresnel_amplitudes(1.25, 0.75, 0.8, 0.0);
    EXPECT_EQ(a.r_s, 1.0);
    EXPECT_EQ(a.r_p, 1.0);
    EXPECT_EQ(a.t_s, 2.0);
}

TEST(Fresnel, GrazingIncidenceReflectsEverything)
{
    for (const Complex n : {kGlass, kGold}) {
        const FresnelAmplitudes a = interface(kAir, n, 0.0);
        EXPECT_EQ(a.r_s, -1.0);
        EXPECT_EQ(a.r_p, -1.0);
        EXPECT_EQ(a.t_s, 0.0);
        EXPECT_EQ(a.t_p, 0.0);
    }
}

TEST(Fresnel, AnInterfaceBetweenEqualMediaIsNotThere)
{
    for (const Complex n : {kAir, kGlass, kGold}) {
        for (const double cosine : {1.0, 0.3, 1e-12, 0.0}) {
            EXPECT_EQ(forward_cosine(n, n, cosine), cosine);
            const FresnelAmplitudes a = interface(n, n, cosine);
            EXPECT_EQ(a.r_s, 0.0);
            EXPECT_EQ(a.r_p, 0.0);
            EXPECT_EQ(a.t_s, 1.0);
            EXPECT_EQ(a.t_p, 1.0);
        }
    }
}

// Beyond the critical angle the field decays, in an absorber it does so at every angle, and
// otherwise it carries power away.
TEST(Fresnel, TheTransmittedWaveDecaysOrLeaves)
{
    const Complex evanescent = forward_cosine(1.5, 1.0, 0.5);
    EXPECT_EQ(evanescent.real(), 0.0);
    EXPECT_NEAR(evanescent.imag(), std::sqrt(2.25 * 0.75 - 1.0), 1e-15);
    EXPECT_GT(forward_cosine(1.0, 1.5, 0.5).real(), 0.0);
    EXPECT_EQ(forward_cosine(1.0, 1.5, 0.5).imag(), 0.0);
    for (const double cosine : {1.0, 0.7, 0.01})
        EXPECT_GT((kGold * forward_cosine(1.0, kGold, cosine)).imag(), 0.0);
}

// Nearly matched media at grazing incidence: 1 − (n_i/n_t)² sin²θ would keep no digit at all.
TEST(Fresnel, NearlyMatchedMediaKeepTheirDigitsAtGrazingIncidence)
{
    constexpr double contrast = 0x1p-40, cosine = 0x1p-20;
    const double q2 = contrast * (2.0 + contrast) + cosine * cosine;  // n_t² − 1 + cos²θ
    const Complex q = (1.0 + contrast) * forward_cosine(1.0, 1.0 + contrast, cosine);
    EXPECT_NEAR(q.real() / std::sqrt(q2), 1.0, 1e-15);
}

RC_GTEST_PROP(Fresnel, SnellKeepsTheTangentialWave, ())
{
    const double n_i = *test::between(1.0, 2.5), cosine = *test::between(0.0, 1.0);
    const Complex n_t = *test::index_of_any();
    const Complex cos_t = forward_cosine(n_i, n_t, cosine);
    const Complex before = n_i * n_i * (1.0 - cosine * cosine),
                  after = n_t * n_t * (1.0 - cos_t * cos_t);
    RC_ASSERT(std::abs(after - before) <= 1e-14 * (1.0 + std::norm(n_t)));
}

// Tangential E and H do not jump: 1 + r_s = t_s, n_i cosθ_i (1 − r_s) = n_t cosθ_t t_s; for p
// n_i (1 + r_p) = n_t t_p, cosθ_i (1 − r_p) = cosθ_t t_p.
RC_GTEST_PROP(Fresnel, TangentialFieldsAreContinuous, ())
{
    const double n_i = *test::between(1.0, 2.5), cosine = *test::between(0.001, 1.0);
    const Complex n_t = *test::index_of_any(), cos_t = forward_cosine(n_i, n_t, cosine);
    const FresnelAmplitudes a = fresnel_amplitudes(n_i, n_t, cosine, cos_t);
    RC_ASSERT(std::abs(1.0 + a.r_s - a.t_s) < 1e-13);
    RC_ASSERT(std::abs(n_i * cosine * (1.0 - a.r_s) - n_t * cos_t * a.t_s) < 1e-13);
    RC_ASSERT(std::abs(n_i * (1.0 + a.r_p) - n_t * a.t_p) < 1e-13);
    RC_ASSERT(std::abs(cosine * (1.0 - a.r_p) - cos_t * a.t_p) < 1e-13);
}

// Stokes: r' = −r, t t' − r r' = 1 for light from the other side at the refracted angle.
RC_GTEST_PROP(Fresnel, TheOtherSideObeysStokes, ())
{
    const double n_i = *test::between(1.0, 2.5), cosine = *test::between(0.001, 1.0);
    const Complex n_t = *test::index_of_any(), cos_t = forward_cosine(n_i, n_t, cosine);
    RC_PRE(n_t != n_i);
    const FresnelAmplitudes a = fresnel_amplitudes(n_i, n_t, cosine, cos_t);
    const FresnelAmplitudes back = fresnel_amplitudes(n_t, n_i, cos_t, cosine);
    RC_ASSERT(std::abs(a.r_s + back.r_s) < 1e-15);
    RC_ASSERT(std::abs(a.r_p + back.r_p) < 1e-15);
    RC_ASSERT(std::abs(a.t_s * back.t_s + a.r_s * a.r_s - 1.0) < 1e-13);
    RC_ASSERT(std::abs(a.t_p * back.t_p + a.r_p * a.r_p - 1.0) < 1e-13);
}

RC_GTEST_PROP(Fresnel, ClearMediaKeepTheEnergy, ())
{
    const double n_i = *test::between(1.0, 2.5), n_t = *test::between(1.0, 2.5);
    const double cosine = *test::between(0.001, 1.0);
    const Complex cos_t = forward_cosine(n_i, n_t, cosine);
    const FresnelAmplitudes a = fresnel_amplitudes(n_i, n_t, cosine, cos_t);
    const double beam = n_t * cos_t.real() / (n_i * cosine);
    RC_ASSERT(std::abs(std::norm(a.r_s) + beam * std::norm(a.t_s) - 1.0) < 1e-13);
    RC_ASSERT(std::abs(std::norm(a.r_p) + beam * std::norm(a.t_p) - 1.0) < 1e-13);
}

/// Indices at 530 nm and reflectances as tables for renderers print them, to two decimals.
TEST(Fresnel, MetalsReflectWhatTablesSay)
{
    struct Metal {
        Complex n;
        double R;
    };
    for (const Metal& metal : {Metal{{1.80, 3.32}, 0.62},  // nickel
                               {{0.83, 2.60}, 0.67},       // copper
                               {{0.31, 2.88}, 0.88},       // gold
                               {{0.12, 3.45}, 0.96}}) {    // silver
        const auto at = fresnel_amplitudes(1.0, metal.n, 1.0, forward_cosine(1.0, metal.n, 1.0));
        EXPECT_NEAR(std::norm(at.r_s), metal.R, 0.005) << metal.n;
        EXPECT_NEAR(std::norm(at.r_p), metal.R, 0.005) << metal.n;
    }
}

}  // namespace
}  // namespace nacre::optics
