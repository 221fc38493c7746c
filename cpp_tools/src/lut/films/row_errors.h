// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace nacre::lut {

/// Weights of Simpson's rule over cosθ, whose nodes are the columns of a table and the points
/// half-way between them. The ends would count half; their error is 0 or does not count.
inline constexpr std::int64_t kTexelWeight = 1, kMidwayWeight = 2;
/// Of a strip of a whole table, times its cosθ, which is ½ on average.
inline constexpr double kStripWeight = 0.5 * (kTexelWeight + kMidwayWeight);

/// The mean error of each row of a table and of each line half-way between two, as seen on a sphere
/// whose film has one thickness: there the area of the picture goes with cosθ.
///
/// Threads add whole numbers, so that the sums do not depend on their order.
class RowErrors {
public:
    /// @param weight  what all that is added to a row weighs together, each times its cosθ
    RowErrors(std::size_t half_rows, double weight) : sums_(half_rows, 0), weight_(weight) {}

    void add(std::size_t half_row, double cos_theta, double error, std::int64_t weight)
    {
        const double weighted = std::min(error, kLargest) * cos_theta;
        std::atomic_ref(sums_[half_row])
            .fetch_add(weight * static_cast<std::int64_t>(weighted * kUnit),
                       std::memory_order_relaxed);
    }

    /// Largest mean of half-rows `first`, `first + 2`, …
    [[nodiscard]] double largest(std::size_t first) const
    {
        std::int64_t sum = 0;
        for (std::size_t i = first; i < sums_.size(); i += 2) sum = std::max(sum, sums_[i]);
        return static_cast<double>(sum) / (kUnit * weight_);
    }

private:
    static constexpr double kUnit = 16777216.0;  // 2^24 of a unit of ΔE00
    static constexpr double kLargest = 1e4;

    std::vector<std::int64_t> sums_;
    double weight_;
};

}  // namespace nacre::lut
