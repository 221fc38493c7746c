// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/vector_clones.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace nacre {
namespace {

using Row = std::array<double, 64>;

NACRE_INLINE double product_and_sum(double a, double b, double c)
{
    return a * b + c;
}

NACRE_VECTOR_CLONES void products_and_sums(const Row& a, const Row& b, Row& c)
{
    for (std::size_t i = 0; i < a.size(); ++i) c[i] = product_and_sum(a[i], b[i], c[i]);
}

// (1 + ε)(1 − ε) = 1 − ε² rounds to 1, so that adding −1 gives 0; a fused multiply-add, which the
// clone for AVX-512 has at hand, would give −ε².
TEST(VectorClones, RoundEveryProduct)
{
    constexpr double kEpsilon = 0x1p-30;
    Row a, b, c;
    a.fill(1.0 + kEpsilon);
    b.fill(1.0 - kEpsilon);
    c.fill(-1.0);
    products_and_sums(a, b, c);
    for (const double value : c) EXPECT_EQ(value, 0.0);
}

}  // namespace
}  // namespace nacre
