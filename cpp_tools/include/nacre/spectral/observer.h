// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

enum class ObserverId { cie1931, cie1964 };

/// Colour-matching functions on the 1 nm grid. Source and citation: data/cmf.
struct Observer {
    Sampled x, y, z;
    double sum_y;  ///< Σ ȳ over the grid: 106.856917 (1931), 116.661877 (1964)
};

[[nodiscard]] const Observer& observer(ObserverId id);

/// "cie1931" or "cie1964". @throws InputError for any other name; the message lists the names.
[[nodiscard]] ObserverId observer_from_name(std::string_view name);
[[nodiscard]] std::string_view observer_name(ObserverId id) noexcept;

}  // namespace nacre::spectral
