// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace nacre::lut {

struct Minimum {
    std::vector<double> at;
    double value;
};

/// Downhill simplex of Nelder and Mead 1965 with their factors 1, 2, 1/2, 1/2.
/// @param step         edge of the first simplex along each axis
/// @param evaluations  at most about so many
[[nodiscard]] Minimum minimise(const std::function<double(const std::vector<double>&)>& function,
                               const std::vector<double>& start, const std::vector<double>& step,
                               int evaluations);

}  // namespace nacre::lut
