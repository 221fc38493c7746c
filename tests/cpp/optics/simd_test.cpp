// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/simd.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

// The elementary functions of the kernels against the C library in extended precision; the bounds
// are those that simd.h states.

namespace nacre::optics::simd {
namespace {

constexpr int kDraws = 200000;

double uniform(std::mt19937_64& engine, double low, double high)
{
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

TEST(Simd, CisTurnsWithinItsBound)
{
    std::mt19937_64 engine(1);
    for (const double range : {0.6, 40.0, 1e6}) {
        double worst = 0.0;
        for (int draw = 0; draw < kDraws; ++draw) {
            const double turns = uniform(engine, -range, range);
            const C cis = cis_turns(V{} + turns);
            const long double whole = std::nearbyint(turns);
            const long double angle =
                2 * std::numbers::pi_v<long double> * (static_cast<long double>(turns) - whole);
            const long double re = cis.re[0], im = cis.im[kWidth - 1];
            worst = std::max(worst, static_cast<double>(std::abs(re - std::cos(angle))));
            worst = std::max(worst, static_cast<double>(std::abs(im - std::sin(angle))));
        }
        EXPECT_LE(worst, 3e-16) << "turns up to " << range;
    }
}

TEST(Simd, CisOfQuarterTurnsIsExact)
{
    const double re[] = {1, 0, -1, 0}, im[] = {0, 1, 0, -1};
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const C cis = cis_turns(V{} + 0.25 * quarter);
        const int place = ((quarter % 4) + 4) % 4;
        EXPECT_EQ(cis.re[0], re[place]) << quarter;
        EXPECT_EQ(cis.im[0], im[place]) << quarter;
    }
}

TEST(Simd, ExpDecayWithinItsBound)
{
    std::mt19937_64 engine(2);
    double worst = 0.0;
    for (int draw = 0; draw < kDraws; ++draw) {
        const double least[] = {-700.0, -2.0, -2.0 * kWeak};
        const double x = uniform(engine, least[draw % 3], 0.0);
        const double found = exp_decay(V{} + x)[0];
        const auto exact = std::exp(static_cast<long double>(x));
        const double ulp =
            std::nextafter(static_cast<double>(exact), 1e300) - static_cast<double>(exact);
        worst = std::max(worst, static_cast<double>(std::abs(found - exact)) / ulp);
    }
    EXPECT_LE(worst, 2.5);
    EXPECT_EQ(exp_decay(V{})[0], 1.0);
    for (const double x : {-700.5, -1e4, -1e300, -std::numeric_limits<double>::infinity()})
        EXPECT_EQ(exp_decay(V{} + x)[0], 0.0) << x;
}

TEST(Simd, ExpDecayOfALaneDoesNotDependOnItsNeighbours)
{
    std::mt19937_64 engine(4);
    for (int draw = 0; draw < kDraws; ++draw) {
        V x;
        for (std::size_t lane = 0; lane < kWidth; ++lane)
            x[lane] = uniform(engine, (lane + draw) % 2 == 0 ? -kWeak : -20.0, 0.0);
        const V together = exp_decay(x);
        for (std::size_t lane = 0; lane < kWidth; ++lane)
            ASSERT_EQ(together[lane], exp_decay(V{} + x[lane])[0]) << x[lane];
    }
}

TEST(Simd, UpperRootSquaresBack)
{
    std::mt19937_64 engine(3);
    for (int draw = 0; draw < kDraws; ++draw) {
        const double re = uniform(engine, -20.0, 20.0);
        const double im = draw % 4 == 0 ? 0.0 : std::exp(uniform(engine, -40.0, 3.0));
        const Root root = upper_root({V{} + re, V{} + im});
        const long double a = root.value.re[0], b = root.value.im[0];
        ASSERT_GE(a, 0.0L);
        ASSERT_GE(b, 0.0L);
        const long double size = std::hypot(static_cast<long double>(re), im);
        ASSERT_LE(std::abs(a * a - b * b - re), 1e-15L * size);
        // The small part keeps its relative precision.
        ASSERT_LE(std::abs(2 * a * b - im), 1e-15L * im);
    }
}

}  // namespace
}  // namespace nacre::optics::simd
