// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/multilayer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "optics/light.h"
#include "support/expect.h"

namespace nacre::optics {
namespace {

using std::numbers::pi;

double cosine_of(double degrees)
{
    return std::cos(degrees * pi / 180.0);
}

double quarter_wave(double n)
{
    return kNm / (4.0 * n);
}

double reflectance(const FilmStack& stack)
{
    return stack_power(stack, 1.0, kNm, Polarisation::s).R;
}

void expect_equal(const FilmStack& a, const FilmStack& b, double cosine, double tolerance)
{
    for (const Polarisation polarisation : kBoth) {
        const Amplitudes x = stack_amplitudes(a, cosine, kNm, polarisation);
        const Amplitudes y = stack_amplitudes(b, cosine, kNm, polarisation);
        EXPECT_COMPLEX_NEAR(x.r, y.r, tolerance);
        EXPECT_COMPLEX_NEAR(x.t, y.t, tolerance);
    }
}

// Two lossy films between air and a lossy substrate, 0.1 rad, lambda = 100 (any length unit).
// Expected amplitudes: tmm 0.2.0, tests.py, basic_test(), which quotes an independent program.
TEST(Multilayer, MatchesTmmOnLossyStack)
{
    const FilmStack stack{
        .ambient = 1.0, .layers = {{{2.0, 4.0}, 2.0}, {{3.0, 0.3}, 3.0}}, .substrate = {1.0, 0.1}};
    const Amplitudes s = stack_amplitudes(stack, std::cos(0.1), 100.0, Polarisation::s);
    const Amplitudes p = stack_amplitudes(stack, std::cos(0.1), 100.0, Polarisation::p);
    EXPECT_COMPLEX_NEAR(s.r, Complex(-0.60331226568845775, -0.093522181653632019), 1e-13);
    EXPECT_COMPLEX_NEAR(s.t, Complex(0.44429533471192989, 0.16921936169383078), 1e-13);
    EXPECT_COMPLEX_NEAR(p.r, Complex(0.60102654255772481, 0.094489146845323682), 1e-13);
    EXPECT_COMPLEX_NEAR(p.t, Complex(0.4461816467503148, 0.17061408427088917), 1e-13);
}

// One interface is Fresnel's, in amplitude and phase.
TEST(Multilayer, NoLayersLeaveTheInterface)
{
    for (const double degrees : {0.0, 35.0, 60.0, 89.9}) {
        for (const Complex substrate : {Complex(1.9), kGold}) {
            const double cosine = cosine_of(degrees);
            const FilmStack bare{.ambient = 1.3, .layers = {}, .substrate = substrate};
            const auto fresnel =
                fresnel_amplitudes(1.3, substrate, cosine, forward_cosine(1.3, substrate, cosine));
            const Amplitudes s = stack_amplitudes(bare, cosine, kNm, Polarisation::s);
            const Amplitudes p = stack_amplitudes(bare, cosine, kNm, Polarisation::p);
            EXPECT_COMPLEX_NEAR(s.r, fresnel.r_s, 1e-14);
            EXPECT_COMPLEX_NEAR(s.t, fresnel.t_s, 1e-14);
            EXPECT_COMPLEX_NEAR(p.r, fresnel.r_p, 1e-14);
            EXPECT_COMPLEX_NEAR(p.t, fresnel.t_p, 1e-14);
        }
    }
}

// Airy: r = (r01 + r12 E)/(1 + r01 r12 E), t = t01 t12 e^{iδ}/(1 + r01 r12 E), δ = 2π n d cosθ/λ.
TEST(Multilayer, OneFilmIsAirysFormula)
{
    const auto airy = [](Complex r01, Complex t01, Complex r12, Complex t12, Complex phase) {
        const Complex below = r12 * phase * phase, series = 1.0 + r01 * below;
        return Amplitudes{(r01 + below) / series, t01 * t12 * phase / series};
    };
    const double d_nm = 180.0;
    for (const Complex film : {Complex(1.38), Complex(2.4, 0.01), kGold}) {
        for (const Complex substrate : {Complex(1.52), Complex(1.0, 6.5), Complex(1.0)}) {
            for (const double degrees : {0.0, 30.0, 60.0, 85.0, 89.9}) {
                const double cos_0 = cosine_of(degrees);
                const Complex cos_1 = forward_cosine(1.1, film, cos_0);
                const Complex cos_2 = forward_cosine(film, substrate, cos_1);
                const auto top = fresnel_amplitudes(1.1, film, cos_0, cos_1);
                const auto bottom = fresnel_amplitudes(film, substrate, cos_1, cos_2);
                const Complex phase = std::exp(Complex(0.0, 2.0 * pi * d_nm / kNm) * film * cos_1);
                const FilmStack stack{1.1, {{film, d_nm}}, substrate};

                const Amplitudes s = airy(top.r_s, top.t_s, bottom.r_s, bottom.t_s, phase);
                const Amplitudes p = airy(top.r_p, top.t_p, bottom.r_p, bottom.t_p, phase);
                const auto ours_s = stack_amplitudes(stack, cos_0, kNm, Polarisation::s);
                const auto ours_p = stack_amplitudes(stack, cos_0, kNm, Polarisation::p);
                EXPECT_COMPLEX_NEAR(ours_s.r, s.r, 2e-14);
                EXPECT_COMPLEX_NEAR(ours_s.t, s.t, 2e-14);
                EXPECT_COMPLEX_NEAR(ours_p.r, p.r, 2e-14);
                EXPECT_COMPLEX_NEAR(ours_p.t, p.t, 2e-14);
            }
        }
    }
}

// R = ((n_s − n²)/(n_s + n²))². Macleod, Thin-Film Optical Filters, single-layer antireflection.
TEST(Multilayer, QuarterWaveFilmHasClosedForm)
{
    constexpr double n = 1.38, n_s = 1.52;  // MgF2 on crown glass
    const FilmStack stack{1.0, {{n, quarter_wave(n)}}, n_s};
    EXPECT_NEAR(reflectance(stack), std::pow((n_s - n * n) / (n_s + n * n), 2), 1e-15);
}

TEST(Multilayer, HalfWaveFilmIsNotSeen)
{
    const FilmStack bare{1.0, {}, 1.52}, coated{1.0, {{2.4, 2.0 * quarter_wave(2.4)}}, 1.52};
    EXPECT_NEAR(reflectance(coated), reflectance(bare), 1e-15);
    EXPECT_NEAR(stack_power(coated, 1.0, kNm, Polarisation::p).T, 1.0 - reflectance(bare), 1e-15);
}

// N pairs multiply the admittance of the substrate by (n_H/n_L)^2N. Macleod, quarter-wave stack.
TEST(Multilayer, QuarterWaveMirrorHasClosedForm)
{
    constexpr double high = 2.4, low = 1.46, n_s = 1.52;
    FilmStack mirror{1.0, {}, n_s};
    for (int pairs = 1; pairs <= 20; ++pairs) {  // 40 layers
        mirror.layers.push_back({high, quarter_wave(high)});
        mirror.layers.push_back({low, quarter_wave(low)});
        const double Y = std::pow(high / low, 2 * pairs) * n_s;
        const PowerRatios power = stack_power(mirror, 1.0, kNm, Polarisation::s);
        EXPECT_NEAR(power.R, std::pow((1.0 - Y) / (1.0 + Y), 2), 1e-14) << pairs;
        EXPECT_NEAR(power.T / (4.0 * Y / ((1.0 + Y) * (1.0 + Y))), 1.0, 1e-12) << pairs;
    }
}

// A gap of air between glass, beyond the critical angle: with q = n cosθ and κ² = n² sin²θ − 1,
// 1/T = 1 + ((q² + κ²)/(2qκ))² sinh²(2πκd/λ) for s; q/n² instead of q for p.
TEST(Multilayer, LightTunnelsThroughAGap)
{
    constexpr double n = 1.5;
    const double cosine = 0.5, q = n * cosine, kappa = std::sqrt(n * n * 0.75 - 1.0);
    const auto tunnelled = [&](double eta, double d_nm) {
        const double mismatch = (eta * eta + kappa * kappa) / (2.0 * eta * kappa);
        return 1.0 / (1.0 + std::pow(mismatch * std::sinh(2.0 * pi * kappa * d_nm / kNm), 2));
    };
    for (const double d_nm : {1.0, 100.0, 1000.0, 20000.0}) {
        const FilmStack gap{n, {{1.0, d_nm}}, n};
        for (const Polarisation polarisation : kBoth) {
            const double eta = polarisation == Polarisation::s ? q : q / (n * n);
            const PowerRatios power = stack_power(gap, cosine, kNm, polarisation);
            EXPECT_NEAR(power.T / tunnelled(eta, d_nm), 1.0, 1e-12) << d_nm;
            EXPECT_NEAR(power.R + power.T, 1.0, 1e-15) << d_nm;
        }
    }
}

TEST(Multilayer, TotalReflectionUnderFilmsIsTotal)
{
    const FilmStack stack{1.5, {{1.38, 150.0}, {2.4, 60.0}, {1.9, 330.0}}, 1.0};
    for (const double degrees : {45.0, 60.0, 89.9}) {
        for (const Polarisation polarisation : kBoth) {
            const PowerRatios power = stack_power(stack, cosine_of(degrees), kNm, polarisation);
            EXPECT_NEAR(power.R, 1.0, 1e-15);
            EXPECT_EQ(power.T, 0.0);
        }
    }
}

// 1.25 · 0.6 = 0.75: the film's q is 0, its matrix is (1, −ik₀d; 0, 1), and r_s is finite.
TEST(Multilayer, AFilmAtItsCriticalAngleIsFinite)
{
    constexpr double d_nm = 300.0;
    const FilmStack stack{1.25, {{0.75, d_nm}}, 1.6};
    const double eta_0 = 1.0, eta_s = std::sqrt(1.6 * 1.6 - 0.75 * 0.75);
    const Complex B(1.0, -2.0 * pi * d_nm / kNm * eta_s);
    const Amplitudes s = stack_amplitudes(stack, 0.8, kNm, Polarisation::s);
    EXPECT_COMPLEX_NEAR(s.r, (eta_0 * B - eta_s) / (eta_0 * B + eta_s), 1e-14);
    EXPECT_COMPLEX_NEAR(s.t, 2.0 * eta_0 / (eta_0 * B + eta_s), 1e-14);
    const PowerRatios p = stack_power(stack, 0.8, kNm, Polarisation::p);
    EXPECT_NEAR(p.R + p.T, 1.0, 1e-14);
}

TEST(Multilayer, ZeroThicknessAndSplitLayersChangeNothing)
{
    const FilmStack plain{1.0, {{2.4, 80.0}, {{1.46, 0.02}, 130.0}}, kGold};
    const FilmStack padded{
        1.0, {{kGold, 0.0}, {2.4, 80.0}, {4.0, 0.0}, {{1.46, 0.02}, 130.0}, {0.7, 0.0}}, kGold};
    const FilmStack split{
        1.0, {{2.4, 50.0}, {2.4, 30.0}, {{1.46, 0.02}, 1.0}, {{1.46, 0.02}, 129.0}}, kGold};
    for (const double degrees : {0.0, 40.0, 70.0, 89.9}) {
        expect_equal(plain, padded, cosine_of(degrees), 1e-15);
        expect_equal(plain, split, cosine_of(degrees), 1e-15);
    }
}

TEST(Multilayer, FilmsOfTheAmbientsIndexOnlyTurnThePhase)
{
    const FilmStack bare{1.3, {}, 1.9}, padded{1.3, {{1.3, 170.0}}, 1.9};
    for (const double cosine : {1.0, 0.5, 1e-3}) {
        const Complex turn = std::polar(1.0, 2.0 * pi * 1.3 * 170.0 * cosine / kNm);
        for (const Polarisation polarisation : kBoth) {
            const Amplitudes x = stack_amplitudes(bare, cosine, kNm, polarisation);
            const Amplitudes y = stack_amplitudes(padded, cosine, kNm, polarisation);
            EXPECT_COMPLEX_NEAR(y.r, x.r * turn * turn, 1e-14);
            EXPECT_COMPLEX_NEAR(y.t, x.t * turn, 1e-14);
        }
    }
}

TEST(Multilayer, FiftyMicrometresOfMetalAreTheBulk)
{
    const FilmStack bulk{1.0, {{1.5, 90.0}}, kGold};
    const FilmStack thick{1.0, {{1.5, 90.0}, {kGold, 50'000.0}, {1.5, 90.0}}, 1.5};
    for (const double degrees : {0.0, 60.0, 89.9}) {
        for (const Polarisation polarisation : kBoth) {
            const PowerRatios power = stack_power(thick, cosine_of(degrees), kNm, polarisation);
            EXPECT_NEAR(power.R, stack_power(bulk, cosine_of(degrees), kNm, polarisation).R, 1e-16);
            EXPECT_GE(power.T, 0.0);
            EXPECT_LT(power.T, 1e-300);
        }
    }
}

// Nothing returns from the far side: t = t01 t12 e^{iδ}, whose power is 1e-251 here.
TEST(Multilayer, OpaqueFilmsKeepTheDigitsOfTheirTransmittance)
{
    constexpr double d_nm = 10'500.0, n_s = 1.5;
    const FilmStack stack{1.0, {{kGold, d_nm}}, n_s};
    const Complex t01 = 2.0 / (1.0 + kGold), t12 = 2.0 * kGold / (kGold + n_s);
    const double log_T =
        std::log(n_s * std::norm(t01 * t12)) - 4.0 * pi * kGold.imag() * d_nm / kNm;
    const double T = stack_power(stack, 1.0, kNm, Polarisation::s).T;
    EXPECT_NEAR(std::log(T), log_T, 1e-12 * std::abs(log_T));
    EXPECT_LT(T, 1e-250);
    EXPECT_GT(T, 1e-252);
}

TEST(Multilayer, GrazingIncidenceReflectsEverything)
{
    const FilmStack stack{1.0, {{1.33, 500.0}, {kGold, 20.0}}, 1.5};
    for (const Polarisation polarisation : kBoth) {
        double previous = stack_power(stack, cosine_of(80.0), kNm, polarisation).R;
        for (const double cosine : {1e-2, 1e-4, 1e-8, 1e-12}) {
            const PowerRatios power = stack_power(stack, cosine, kNm, polarisation);
            EXPECT_LE(power.R, 1.0);
            EXPECT_GE(power.T, 0.0);
            EXPECT_GT(power.R, previous);
            previous = power.R;
        }
        EXPECT_NEAR(previous, 1.0, 1e-10);
    }
}

TEST(Multilayer, UnpolarisedIsTheMeanOfBoth)
{
    const FilmStack stack{1.0, {{{2.1, 0.02}, 240.0}}, 1.5};
    const PowerRatios s = stack_power(stack, 0.4, kNm, Polarisation::s);
    const PowerRatios p = stack_power(stack, 0.4, kNm, Polarisation::p);
    const PowerRatios u = stack_power_unpolarised(stack, 0.4, kNm);
    EXPECT_DOUBLE_EQ(u.R, 0.5 * (s.R + p.R));
    EXPECT_DOUBLE_EQ(u.T, 0.5 * (s.T + p.T));
    EXPECT_NEAR(u.A, 0.5 * (s.A + p.A), 1e-16);
    EXPECT_GT(std::abs(s.R - p.R), 0.01);
}

struct Wrong {
    FilmStack stack;
    const char* field;
    int index;
    const char* message;
};

TEST(Multilayer, ValidateNamesWhatIsWrong)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const char* positive = "real part must be > 0";
    const char* thickness = "must be finite and ≥ 0";
    const Wrong cases[] = {
        {{1.0, {{1.3, -1.0}}, 1.5}, "d_nm", 0, thickness},
        {{1.0, {{1.3, 10.0}, {1.4, nan}}, 1.5}, "d_nm", 1, thickness},
        {{1.0, {{1.3, infinity}}, 1.5}, "d_nm", 0, thickness},
        {{0.0, {}, 1.5}, "n", 0, positive},
        {{1.0, {{-1.3, 10.0}}, 1.5}, "n", 1, positive},
        {{1.0, {{1.3, 10.0}}, {0.0, 2.0}}, "n", 2, positive},
        {{1.0, {{{nan, 0.0}, 10.0}}, 1.5}, "n", 1, "must be finite"},
        {{1.0, {}, {1.0, infinity}}, "n", 1, "must be finite"},
        {{{1.0, 0.1}, {}, 1.5}, "n", 0, "the ambient must not absorb (imaginary part 0)"},
        {{1.0, {}, {1.5, -1e-9}},
         "n",
         1,
         "imaginary part must be ≥ 0 (media with gain are not supported)"},
        {{1.0, std::vector<Layer>(65, {1.3, 1.0}), 1.5}, "d_nm", 64, "at most 64 layers"},
    };
    for (const Wrong& wrong : cases) {
        const auto problem = validate(wrong.stack);
        ASSERT_TRUE(problem) << wrong.message;
        EXPECT_STREQ(problem->field, wrong.field);
        EXPECT_EQ(problem->index, wrong.index);
        EXPECT_STREQ(problem->message, wrong.message);
    }
    EXPECT_FALSE(validate({1.0, std::vector<Layer>(64, {kGold, 0.0}), kGold}));
}

}  // namespace
}  // namespace nacre::optics
