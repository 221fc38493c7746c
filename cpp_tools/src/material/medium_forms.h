// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "nacre/material/section.h"

namespace nacre::material {

/// The keys of which a medium has exactly one.
inline constexpr std::array<std::string_view, 5> kMediumForms{"medium", "n", "cauchy", "sellmeier",
                                                              "abbe"};

inline constexpr Bounds kMediumIndex{.min = 0.0, .max = 100.0, .exclusive_min = true};
inline constexpr Bounds kMediumAbsorption{0.0, 100.0};
inline constexpr Bounds kAbbe{.min = 0.0, .exclusive_min = true};
inline constexpr std::size_t kMostCauchyTerms = 3, kMostSellmeierTerms = 6;

}  // namespace nacre::material
