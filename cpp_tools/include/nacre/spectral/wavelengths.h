// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

/// @file
/// The wavelength grid that every colour integral uses.

namespace nacre::spectral {

inline constexpr int kFirstNm = 360;
inline constexpr int kLastNm = 830;
inline constexpr std::size_t kWavelengths = kLastNm - kFirstNm + 1;  ///< 471, every 1 nm

/// Values on the grid; element i belongs to `wavelength_nm(i)`.
using Sampled = std::array<double, kWavelengths>;

[[nodiscard]] constexpr double wavelength_nm(std::size_t i) noexcept
{
    return kFirstNm + static_cast<double>(i);
}

}  // namespace nacre::spectral
