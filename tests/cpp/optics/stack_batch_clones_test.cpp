// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nacre/optics/stack_batch.h"
#include "stack_batch_clone.h"

namespace nacre_clones {
namespace {

Input random_input(std::size_t layers, unsigned seed)
{
    constexpr std::size_t kLanes = nacre::optics::kLanes;
    std::mt19937 engine(seed);
    Input input{layers, {}};
    const auto lanes = [&](double low, double high) {
        for (std::size_t i = 0; i < kLanes; ++i)
            input.values.push_back(low +
                                   (high - low) * static_cast<double>(engine()) / 4294967296.0);
    };
    lanes(1.0, 1.6);    // ambient
    lanes(0.001, 1.0);  // cosine
    lanes(0.2, 3.0);    // substrate
    lanes(0.0, 4.0);
    for (std::size_t j = 0; j < layers; ++j) {
        lanes(0.2, 3.0);
        j % 2 == 0 ? lanes(0.0, 0.0) : lanes(0.0, 3.0);
        j % 3 == 0 ? lanes(0.0, 40.0) : lanes(0.0, 1.0);
    }
    return input;
}

/// Fused products change roundings only: 1e-13, and near a critical angle what `doubt` says there.
void expect_same_results(Kernels kernels)
{
    constexpr std::size_t kLanes = nacre::optics::kLanes;
    constexpr std::size_t kDoubt = 12;  ///< place among the blocks of 32 numbers
    for (const std::size_t layers : {0, 1, 2, 5, 16}) {
        for (unsigned seed = 0; seed < 20; ++seed) {
            const Input input = random_input(layers, seed);
            const std::vector<double> expected = run_portable(input), found = kernels(input);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                ASSERT_TRUE(std::isfinite(expected[i])) << i;
                const double doubt = expected[kDoubt * kLanes + i % kLanes];
                ASSERT_NEAR(found[i], expected[i],
                            (1e-13 + doubt) * std::max(1.0, std::abs(expected[i])))
                    << "number " << i << ", " << layers << " layers, seed " << seed;
            }
        }
    }
}

#if defined(__x86_64__)
TEST(StackBatchClones, Avx2AgreesWithThePortableCode)
{
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
        GTEST_SKIP() << "this machine has no AVX2 with FMA";
    expect_same_results(run_avx2);
}

TEST(StackBatchClones, Avx512AgreesWithThePortableCode)
{
    if (!__builtin_cpu_supports("avx512vl") || !__builtin_cpu_supports("avx512dq"))
        GTEST_SKIP() << "this machine has no AVX-512";
    expect_same_results(run_avx512);
}
#endif

// What the library itself chose, through its public functions.
TEST(StackBatchClones, TheLibraryAgreesWithThePortableCode)
{
    const Input input = random_input(3, 99);
    const std::vector<double> expected = run_portable(input);
    constexpr std::size_t kLanes = nacre::optics::kLanes;
    const auto copy = [&](std::size_t block, nacre::optics::Lanes& lanes) {
        for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = input.values[block * kLanes + i];
    };
    nacre::optics::LaneStack stack;
    copy(0, stack.n_0);
    copy(1, stack.cos_0);
    copy(0, stack.above.re);
    stack.above.im.fill(0.0);
    copy(2, stack.below.re);
    copy(3, stack.below.im);
    stack.layers.resize(input.layers);
    for (std::size_t j = 0; j < input.layers; ++j) {
        copy(4 + 3 * j, stack.layers[j].n.re);
        copy(5 + 3 * j, stack.layers[j].n.im);
        copy(6 + 3 * j, stack.layers[j].waves);
    }
    nacre::optics::BatchPower power;
    nacre::optics::BatchAmplitudes amplitudes;
    stack_batch(stack, power, amplitudes);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double allowed = 1e-13 + power.doubt[i];
        EXPECT_NEAR(amplitudes.s.r.re[i], expected[i], allowed);
        EXPECT_NEAR(power.p.T[i], expected[11 * kLanes + i], allowed);
    }
}

}  // namespace
}  // namespace nacre_clones
