// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
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

void expect_same_bits(Kernels kernels)
{
    for (const std::size_t layers : {0, 1, 2, 5, 16}) {
        for (unsigned seed = 0; seed < 20; ++seed) {
            const Input input = random_input(layers, seed);
            const std::vector<double> expected = run_portable(input), found = kernels(input);
            ASSERT_EQ(found.size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                ASSERT_TRUE(std::isfinite(expected[i])) << i;
                ASSERT_EQ(std::bit_cast<std::uint64_t>(found[i]),
                          std::bit_cast<std::uint64_t>(expected[i]))
                    << "number " << i << ", " << layers << " layers, seed " << seed;
            }
        }
    }
}

#if defined(__x86_64__)
TEST(StackBatchClones, Avx2GivesTheBitsOfThePortableCode)
{
    if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this machine has no AVX2";
    expect_same_bits(run_avx2);
}

TEST(StackBatchClones, Avx512GivesTheBitsOfThePortableCode)
{
    if (!__builtin_cpu_supports("avx512f")) GTEST_SKIP() << "this machine has no AVX-512";
    expect_same_bits(run_avx512);
}
#endif

// What the library itself chose, through its public functions.
TEST(StackBatchClones, TheLibraryGivesTheBitsOfThePortableCode)
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
    nacre::optics::BatchResponse response;
    stack_batch(stack, response);
    for (std::size_t i = 0; i < kLanes; ++i) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(response.s.r.re[i]),
                  std::bit_cast<std::uint64_t>(expected[i]));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(response.p.T[i]),
                  std::bit_cast<std::uint64_t>(expected[11 * kLanes + i]));
        EXPECT_EQ(std::bit_cast<std::uint64_t>(response.doubt[i]),
                  std::bit_cast<std::uint64_t>(expected[12 * kLanes + i]));
    }
}

}  // namespace
}  // namespace nacre_clones
