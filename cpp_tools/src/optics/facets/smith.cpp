// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/smith.h"

#include <algorithm>
#include <cmath>

namespace nacre::optics {

double smith_lambda(double cos_theta, double alpha) noexcept
{
    const double squared = std::max(cos_theta * cos_theta, 1e-12);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - squared) / squared) - 1.0);
}

}  // namespace nacre::optics
