// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

/// @file
/// Colours as three numbers, and the matrices between their spaces.

namespace nacre::spectral {

using Vec3 = std::array<double, 3>;
using Mat3 = std::array<Vec3, 3>;  ///< rows

[[nodiscard]] Vec3 multiply(const Mat3& m, const Vec3& v) noexcept;
[[nodiscard]] Mat3 multiply(const Mat3& a, const Mat3& b) noexcept;
[[nodiscard]] Mat3 transposed(const Mat3& m) noexcept;
[[nodiscard]] double determinant(const Mat3& m) noexcept;
/// @pre `m` is regular, as every matrix between colour spaces is.
[[nodiscard]] Mat3 inverse(const Mat3& m) noexcept;
[[nodiscard]] Mat3 diagonal(const Vec3& v) noexcept;

}  // namespace nacre::spectral
