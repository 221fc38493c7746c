// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/bands/fine_grid.h"
#include "nacre/spectral/matrix.h"
#include "nacre/spectral/observer.h"

namespace nacre::bands {

/// What the eye makes of each wavelength.
struct Eye {
    std::vector<spectral::Vec3> xyz;  ///< on the fine grid, over ∫ ȳ dλ
    Fine sum;                         ///< x̄ + ȳ + z̄

    /// Linear between the tables' nanometres.
    [[nodiscard]] spectral::Vec3 at(double nm) const noexcept;
    spectral::ObserverId observer;
    double per_y;  ///< 1 / ∫ ȳ dλ
};

[[nodiscard]] const Eye& eye(spectral::ObserverId observer);

}  // namespace nacre::bands
