// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

#include "lanes/simd.h"

// fma_peak THREADS: what the processor can do at most, in GFLOP/s, with the vectors that the
// kernels use. Chains of multiply-adds that do not wait for each other keep every unit busy.

namespace {

namespace simd = nacre::optics::simd;

constexpr std::size_t kChains = 12;  // latency 4 or 5, two units
constexpr std::size_t kRounds = 20'000'000;
constexpr double kFlops = 2.0 * simd::kWidth * kChains * kRounds;

NACRE_VECTOR_CLONES double sum_of_chains(double by, double plus)
{
    simd::V chains[kChains] = {};
    for (std::size_t round = 0; round < kRounds; ++round)
        for (simd::V& chain : chains) chain = chain * by + plus;
    simd::V sum{};
    for (const simd::V& chain : chains) sum += chain;
    return sum[0] + sum[1] + sum[2] + sum[3];
}

double seconds(std::size_t threads)
{
    std::vector<double> sums(threads);
    const auto start = std::chrono::steady_clock::now();
    {
        std::vector<std::jthread> workers;
        workers.reserve(threads);
        for (double& sum : sums)
            workers.emplace_back([&sum] { sum = sum_of_chains(0.999999, 1e-6); });
    }
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    // All sums are alike; that they are looked at keeps them from being left out.
    return std::ranges::all_of(sums, [&](double sum) { return sum == sums[0]; }) ? taken.count()
                                                                                 : 0.0;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto threads = static_cast<std::size_t>(argc > 1 ? std::atoi(argv[1]) : 1);
    double best = seconds(threads);
    for (int repeat = 0; repeat < 4; ++repeat) best = std::min(best, seconds(threads));
    std::printf("%.3f\n", kFlops * static_cast<double>(threads) / best * 1e-9);
}
