// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "nacre/capi/stacks.h"
#include "support/not_numbers.h"

namespace {

using nacre::test::kNan;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Arguments of nacre_stack for `count` copies of one film on glass.
struct Call {
    explicit Call(std::size_t copies = 1) : count(copies)
    {
        for (std::size_t i = 0; i < count; ++i) {
            n.insert(n.end(), {1.0, 0.0, 2.1, 0.02, 1.5, 0.0});
            d_nm.push_back(240.0 + static_cast<double>(i));
            angle.push_back(65.0 - 0.01 * static_cast<double>(i));
            wavelength.push_back(550.0);
        }
        power.assign(3 * count, -7.0);
        amplitudes.assign(4 * count, -7.0);
    }
    nacre_status operator()()
    {
        return nacre_stack(count, layers, n.data(), d_nm.data(), angle.data(), wavelength.data(),
                           coherence, polarisation, power.data(),
                           wants_amplitudes ? amplitudes.data() : nullptr,
                           absorption.empty() ? nullptr : absorption.data());
    }
    std::size_t count, layers = 1;
    std::vector<double> n, d_nm, angle, wavelength, power, amplitudes, absorption;
    const nacre_coherence* coherence = nullptr;
    nacre_polarisation polarisation = NACRE_S;
    bool wants_amplitudes = true;
};

TEST(CapiStack, BareGlassByHand)
{
    const double n[] = {1.0, 0.0, 1.5, 0.0}, angle = 0.0, wavelength = 550.0;
    double power[3], amplitudes[4];
    ASSERT_EQ(nacre_stack(1, 0, n, nullptr, &angle, &wavelength, nullptr, NACRE_P, power,
                          amplitudes, nullptr),
              NACRE_OK);
    EXPECT_NEAR(power[0], 0.04, 1e-15);
    EXPECT_NEAR(power[1], 0.96, 1e-15);
    EXPECT_NEAR(power[2], 0.0, 1e-15);
    EXPECT_NEAR(amplitudes[0], 0.2, 1e-15);  // r_p = −r_s
    EXPECT_NEAR(amplitudes[2], 0.8, 1e-15);
    EXPECT_EQ(std::abs(amplitudes[1]) + std::abs(amplitudes[3]), 0.0);
}

TEST(CapiStack, UnpolarisedIsTheMean)
{
    Call s(40), p(40), u(40);
    p.polarisation = NACRE_P;
    u.polarisation = NACRE_UNPOLARISED;
    u.wants_amplitudes = false;
    ASSERT_EQ(s(), NACRE_OK);
    ASSERT_EQ(p(), NACRE_OK);
    ASSERT_EQ(u(), NACRE_OK);
    for (std::size_t i = 0; i < u.power.size(); ++i)
        EXPECT_NEAR(u.power[i], 0.5 * (s.power[i] + p.power[i]), 1e-15);
}

// A layer is incoherent where its flag is 0; a window then keeps 2R/(1 + R).
TEST(CapiStack, FlagsMakeLayersIncoherent)
{
    const double n[] = {1.0, 0.0, 1.5, 0.0, 1.0, 0.0}, d_nm = 1e6, angle = 0.0, nm = 550.0;
    const unsigned char yes = 1, no = 0;
    const nacre_coherence coherent{&yes, nullptr, 0.0}, incoherent{&no, nullptr, 0.0};
    double window[3], film[3], none[3];
    ASSERT_EQ(nacre_stack(1, 1, n, &d_nm, &angle, &nm, &incoherent, NACRE_UNPOLARISED, window,
                          nullptr, nullptr),
              NACRE_OK);
    ASSERT_EQ(nacre_stack(1, 1, n, &d_nm, &angle, &nm, &coherent, NACRE_UNPOLARISED, film, nullptr,
                          nullptr),
              NACRE_OK);
    ASSERT_EQ(nacre_stack(1, 1, n, &d_nm, &angle, &nm, nullptr, NACRE_UNPOLARISED, none, nullptr,
                          nullptr),
              NACRE_OK);
    EXPECT_NEAR(window[0], 0.08 / 1.04, 1e-15);
    EXPECT_EQ(film[0], none[0]);
    EXPECT_NE(film[0], window[0]);
}

// A great spread is incoherent, a band of wavelengths is a spread that grows with the thickness.
TEST(CapiStack, SpreadAndBandwidth)
{
    const double great = 5000.0, sigma = 2.0 / (2.0 * std::sqrt(2.0 * std::log(2.0)));
    const double equal = 240.0 * sigma / 550.0;
    const unsigned char flag = 0;
    const nacre_coherence incoherent{&flag, nullptr, 0.0}, spread{nullptr, &great, 0.0};
    const nacre_coherence band{nullptr, nullptr, 2.0}, spread_like_band{nullptr, &equal, 0.0};
    const auto R = [](const nacre_coherence* coherence, double k) {
        Call call;
        call.n[3] = k;
        call.coherence = coherence;
        call.wants_amplitudes = false;
        EXPECT_EQ(call(), NACRE_OK) << nacre_last_error();
        return call.power[0];
    };
    EXPECT_NEAR(R(&spread, 0.0), R(&incoherent, 0.0), 1e-15);
    EXPECT_NEAR(R(&band, 0.02), R(&spread_like_band, 0.02), 1e-15);
    EXPECT_GT(std::abs(R(&band, 0.02) - R(nullptr, 0.02)), 1e-6);
}

TEST(CapiStack, AbsorptionByLayer)
{
    Call call(40);
    call.absorption.assign(40, -7.0);
    ASSERT_EQ(call(), NACRE_OK);
    for (std::size_t i = 0; i < 40; ++i)
        EXPECT_NEAR(call.absorption[i], call.power[3 * i + 2], 1e-13);

    Call u = call;
    u.polarisation = NACRE_UNPOLARISED;
    u.wants_amplitudes = false;
    ASSERT_EQ(u(), NACRE_OK);
    EXPECT_NEAR(u.absorption[0], u.power[2], 1e-13);
    EXPECT_NE(u.absorption[0], call.absorption[0]);

    const double spread = 5.0;
    const nacre_coherence coherence{nullptr, &spread, 0.0};
    u.coherence = &coherence;
    EXPECT_EQ(u(), NACRE_INPUT);
    EXPECT_STREQ(
        nacre_last_error(),
        "absorption: by layer is not known where layers have a spread or light a bandwidth");
}

TEST(CapiStack, CoherenceIsChecked)
{
    const unsigned char flag = 0;
    const double spread = 5.0, negative = -1.0;
    Call call;
    call.wants_amplitudes = false;
    const auto message = [&call](const nacre_coherence& coherence) -> std::string {
        call.coherence = &coherence;
        EXPECT_EQ(call(), NACRE_INPUT);
        return nacre_last_error();
    };
    EXPECT_EQ(message({nullptr, nullptr, kNan}), "bandwidth_nm: must be finite and ≥ 0 (got nan)");
    EXPECT_EQ(message({nullptr, &negative, 0.0}), "spread_nm[0]: must be finite and ≥ 0 (got -1)");
    EXPECT_EQ(message({&flag, &spread, 0.0}),
              "spread_nm[0]: must be 0 in a layer that is incoherent (got 5)");
}

// Neighbours, batch sizes and places in a batch leave no trace, also where an item is computed in
// extended precision (here the 5th of every 7, at a film's critical angle).
TEST(CapiStack, AnItemDoesNotDependOnItsBatch)
{
    constexpr std::size_t kMost = 200;
    Call all(kMost);
    for (std::size_t i = 4; i < kMost; i += 7) {
        all.n[6 * i] = 1.25;
        all.n[6 * i + 2] = 0.75;
        all.n[6 * i + 3] = 0.0;
        all.angle[i] = std::acos(0.8) * 180.0 / M_PI;
    }
    ASSERT_EQ(all(), NACRE_OK);
    for (const std::size_t count : {1, 2, 31, 32, 33, 63, 64, 65, 127, 199}) {
        const std::size_t first = kMost - count;
        std::vector<double> power(3 * count), amplitudes(4 * count);
        ASSERT_EQ(nacre_stack(count, 1, &all.n[6 * first], &all.d_nm[first], &all.angle[first],
                              &all.wavelength[first], nullptr, NACRE_S, power.data(),
                              amplitudes.data(), nullptr),
                  NACRE_OK);
        EXPECT_EQ(std::memcmp(power.data(), &all.power[3 * first], 24 * count), 0) << count;
        EXPECT_EQ(std::memcmp(amplitudes.data(), &all.amplitudes[4 * first], 32 * count), 0);
    }
}

/// 3 thicknesses × 40 angles × 25 wavelengths, dispersive: each argument stored once.
struct Grid {
    std::vector<std::size_t> shape{3, 40, 25};
    std::size_t n_steps[3]{0, 0, 1}, d_steps[3]{1, 0, 0}, angle_steps[3]{0, 1, 0};
    std::vector<double> n, d_nm{20.0, 90.0, 240.0}, angle, wavelength;
    std::vector<double> power = std::vector<double>(9000, -7.0), amplitudes{};

    Grid()
    {
        for (int i = 0; i < 25; ++i) {
            wavelength.push_back(380.0 + 16.0 * i);
            n.insert(n.end(),
                     {1.0, 0.0, 2.1 + 1e4 / (wavelength[i] * wavelength[i]), 0.02, 1.5, 0.0});
        }
        for (int i = 0; i < 40; ++i) angle.push_back(2.2 * i);
        amplitudes.assign(12000, -7.0);
    }
    nacre_status operator()(const size_t* lengths, const size_t* steps_of_n)
    {
        return nacre_stack_grid(shape.size(), lengths, 1, {n.data(), steps_of_n},
                                {d_nm.data(), d_steps}, {angle.data(), angle_steps},
                                {wavelength.data(), n_steps}, nullptr, NACRE_P, power.data(),
                                amplitudes.data(), nullptr);
    }
    nacre_status operator()() { return (*this)(shape.data(), n_steps); }
};

TEST(CapiStackGrid, GivesTheBitsOfEachItemByItself)
{
    Grid grid;
    ASSERT_EQ(grid(), NACRE_OK);
    for (std::size_t item = 0; item < 3000; ++item) {
        const std::size_t d = item / 1000, a = item / 25 % 40, w = item % 25;
        double power[3], amplitudes[4];
        ASSERT_EQ(nacre_stack(1, 1, &grid.n[6 * w], &grid.d_nm[d], &grid.angle[a],
                              &grid.wavelength[w], nullptr, NACRE_P, power, amplitudes, nullptr),
                  NACRE_OK);
        ASSERT_EQ(std::memcmp(power, &grid.power[3 * item], sizeof power), 0) << item;
        ASSERT_EQ(std::memcmp(amplitudes, &grid.amplitudes[4 * item], sizeof amplitudes), 0)
            << item;
    }
}

TEST(CapiStackGrid, WithoutAxesIsOneItem)
{
    Grid grid;
    double alone[3];
    const nacre_grid_array n{grid.n.data(), nullptr}, d{grid.d_nm.data(), nullptr};
    const nacre_grid_array angle{grid.angle.data(), nullptr};
    const nacre_grid_array wavelength{grid.wavelength.data(), nullptr};
    ASSERT_EQ(nacre_stack_grid(0, nullptr, 1, n, d, angle, wavelength, nullptr, NACRE_P, alone,
                               nullptr, nullptr),
              NACRE_OK);
    ASSERT_EQ(grid(), NACRE_OK);
    EXPECT_EQ(std::memcmp(alone, grid.power.data(), sizeof alone), 0);
}

TEST(CapiStackGrid, AnEmptyAxisIsNoError)
{
    Grid grid;
    grid.shape[1] = 0;
    EXPECT_EQ(grid(), NACRE_OK);
    EXPECT_EQ(grid.power[0], -7.0);
}

// The first item that the wrong element belongs to, counted as in the results.
TEST(CapiStackGrid, RefusesBadElementsByTheirFirstItem)
{
    const auto with = [](auto&& change) {
        Grid grid;
        change(grid);
        EXPECT_EQ(grid(), NACRE_INPUT);
        EXPECT_EQ(grid.power[0], -7.0);
        return std::string(nacre_last_error());
    };
    EXPECT_EQ(with([](Grid& g) { g.d_nm[2] = -1.0; }),
              "d_nm[0]: must be finite and ≥ 0 (got -1) (item 2000)");
    EXPECT_EQ(with([](Grid& g) { g.angle[39] = 90.0; }),
              "angle_deg: must be in [0, 90) (got 90) (item 975)");
    EXPECT_EQ(with([](Grid& g) { g.wavelength[24] = kNan; }),
              "wavelength_nm: must be finite and > 0 (got nan) (item 24)");
    EXPECT_EQ(with([](Grid& g) {
                  g.n[6 * 3 + 4] = -1.5;
                  g.angle[1] = -2.0;
              }),
              "n[2]: real part must be > 0 (got -1.5+0i) (item 3)");
}

TEST(CapiStackGrid, RefusesNull)
{
    Grid grid;
    EXPECT_EQ(grid(nullptr, grid.n_steps), NACRE_INPUT);
    EXPECT_STREQ(nacre_last_error(), "shape: must not be null");
    EXPECT_EQ(grid(grid.shape.data(), nullptr), NACRE_INPUT);
    EXPECT_STREQ(nacre_last_error(), "n: must not be null");
}

TEST(CapiStack, NoItemsAreNoError)
{
    EXPECT_EQ(nacre_stack(0, 3, nullptr, nullptr, nullptr, nullptr, nullptr, NACRE_S, nullptr,
                          nullptr, nullptr),
              NACRE_OK);
}

void expect_refused(Call& call, const std::string& message)
{
    EXPECT_EQ(call(), NACRE_INPUT) << message;
    EXPECT_EQ(nacre_last_error(), message);
    for (const double value : call.power) EXPECT_EQ(value, -7.0) << message;
    for (const double value : call.amplitudes) EXPECT_EQ(value, -7.0) << message;
}

TEST(CapiStack, RefusesBadNumbersAndLeavesTheOutputsAlone)
{
    struct Bad {
        std::vector<double> Call::*array;
        std::size_t at;
        double value;
        const char* message;
    };
    const Bad cases[] = {
        {&Call::d_nm, 37, -5.0, "d_nm[0]: must be finite and ≥ 0 (got -5) (item 37)"},
        {&Call::d_nm, 0, kNan, "d_nm[0]: must be finite and ≥ 0 (got nan) (item 0)"},
        {&Call::d_nm, 0, kInfinity, "d_nm[0]: must be finite and ≥ 0 (got inf) (item 0)"},
        {&Call::n, 2, 0.0, "n[1]: real part must be > 0 (got 0+0.02i) (item 0)"},
        {&Call::n, 2, -1.3, "n[1]: real part must be > 0 (got -1.3+0.02i) (item 0)"},
        {&Call::n, 6 * 39 + 4, kNan, "n[2]: must be finite (got nan+0i) (item 39)"},
        {&Call::n, 3, -0.02,
         "n[1]: imaginary part must be ≥ 0 (media with gain are not supported) (got 2.1-0.02i) "
         "(item 0)"},
        {&Call::n, 1, 0.1,
         "n[0]: the ambient must not absorb (imaginary part 0) (got 1+0.1i) (item 0)"},
        {&Call::angle, 0, 90.0, "angle_deg: must be in [0, 90) (got 90) (item 0)"},
        {&Call::angle, 33, -1.0, "angle_deg: must be in [0, 90) (got -1) (item 33)"},
        {&Call::angle, 0, kNan, "angle_deg: must be in [0, 90) (got nan) (item 0)"},
        {&Call::wavelength, 0, 0.0, "wavelength_nm: must be finite and > 0 (got 0) (item 0)"},
        {&Call::wavelength, 0, kInfinity,
         "wavelength_nm: must be finite and > 0 (got inf) (item 0)"},
    };
    for (const Bad& bad : cases) {
        Call call(40);
        (call.*bad.array)[bad.at] = bad.value;
        expect_refused(call, bad.message);
    }
}

TEST(CapiStack, RefusesAmplitudesThatDoNotExist)
{
    Call unpolarised;
    unpolarised.polarisation = NACRE_UNPOLARISED;
    expect_refused(unpolarised, "amplitudes: exist for s or p and coherent layers only");
    Call mixed;
    const unsigned char flag = 0;
    const nacre_coherence incoherent{&flag, nullptr, 0.0};
    mixed.coherence = &incoherent;
    expect_refused(mixed, "amplitudes: exist for s or p and coherent layers only");
}

TEST(CapiStack, RefusesUnknownPolarisations)
{
    Call call;
    const int unknown = 3;
    std::memcpy(&call.polarisation, &unknown, sizeof unknown);
    expect_refused(call, "polarisation: must be s, p or u");
}

TEST(CapiStack, RefusesTooManyLayers)
{
    Call call;
    call.layers = 65;
    call.n.assign(2 * 67, 1.0);
    call.d_nm.assign(65, 1.0);
    expect_refused(call, "d_nm: must have at most 64 layers (got 65)");
    call.layers = std::numeric_limits<std::size_t>::max();
    EXPECT_EQ(call(), NACRE_INPUT);
}

TEST(CapiStack, RefusesNull)
{
    Call c;
    double* power = c.power.data();
    const double *n = c.n.data(), *d = c.d_nm.data(), *a = c.angle.data(), *w = c.wavelength.data();
    const auto error = [](nacre_status status) {
        EXPECT_EQ(status, NACRE_INPUT);
        return std::string(nacre_last_error());
    };
    const auto s = NACRE_S;
    EXPECT_EQ(error(nacre_stack(1, 1, nullptr, d, a, w, nullptr, s, power, nullptr, nullptr)),
              "n: must not be null");
    EXPECT_EQ(error(nacre_stack(1, 1, n, nullptr, a, w, nullptr, s, power, nullptr, nullptr)),
              "d_nm: must not be null");
    EXPECT_EQ(error(nacre_stack(1, 1, n, d, nullptr, w, nullptr, s, power, nullptr, nullptr)),
              "angle_deg: must not be null");
    EXPECT_EQ(error(nacre_stack(1, 1, n, d, a, nullptr, nullptr, s, power, nullptr, nullptr)),
              "wavelength_nm: must not be null");
    EXPECT_EQ(error(nacre_stack(1, 1, n, d, a, w, nullptr, s, nullptr, nullptr, nullptr)),
              "power: must not be null");
}

TEST(CapiStack, ErrorsBelongToTheirThread)
{
    Call here;
    here.angle[0] = 91.0;
    ASSERT_EQ(here(), NACRE_INPUT);
    const std::string message = nacre_last_error();
    std::vector<std::string> found(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < found.size(); ++i)
        threads.emplace_back([i, &found] {
            EXPECT_STREQ(nacre_last_error(), "");  // nothing failed here yet
            for (int turn = 0; turn < 200; ++turn) {
                Call there;
                there.d_nm[0] = -1.0 - static_cast<double>(i);
                EXPECT_EQ(there(), NACRE_INPUT);
                found[i] = nacre_last_error();
                Call good;
                EXPECT_EQ(good(), NACRE_OK);
                EXPECT_EQ(nacre_last_error(), found[i]);  // a success does not wipe it out
            }
        });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(found[i],
                  "d_nm[0]: must be finite and ≥ 0 (got -" + std::to_string(i + 1) + ") (item 0)");
    EXPECT_EQ(nacre_last_error(), message);
}

TEST(CapiStack, ThreadsGetTheSameBits)
{
    Call expected(500);
    ASSERT_EQ(expected(), NACRE_OK);
    std::vector<Call> calls(4, Call(500));
    std::vector<std::thread> threads;
    for (Call& call : calls)
        threads.emplace_back([&call] {
            for (int turn = 0; turn < 20; ++turn) EXPECT_EQ(call(), NACRE_OK);
        });
    for (std::thread& thread : threads) thread.join();
    for (const Call& call : calls) {
        EXPECT_EQ(call.power, expected.power);
        EXPECT_EQ(call.amplitudes, expected.amplitudes);
    }
}

}  // namespace
