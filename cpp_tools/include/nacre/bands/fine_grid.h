// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "nacre/spectral/wavelengths.h"

/// @file
/// The grid that bands are made on and measured against: tenths of a nanometre.

namespace nacre::bands {

inline constexpr double kStepNm = 0.1;
inline constexpr std::size_t kFineWavelengths =
    static_cast<std::size_t>(spectral::kLastNm - spectral::kFirstNm) * 10;  ///< 4700

/// The middle of step i, which ∫ f dλ = Σ f(fine_nm(i)) · kStepNm reads f at.
[[nodiscard]] constexpr double fine_nm(std::size_t i) noexcept
{
    return spectral::kFirstNm + kStepNm * (static_cast<double>(i) + 0.5);
}

/// The step that begins nearest to a wavelength; kFineWavelengths at the end.
[[nodiscard]] std::size_t step_of(double nm) noexcept;

/// All of them, ascending.
[[nodiscard]] const std::vector<double>& fine_grid();

/// Values on the fine grid.
using Fine = std::vector<double>;

}  // namespace nacre::bands
