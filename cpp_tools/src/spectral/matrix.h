// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/spectral/colour.h"

namespace nacre::spectral {

[[nodiscard]] Vec3 multiply(const Mat3& m, const Vec3& v) noexcept;
[[nodiscard]] Mat3 multiply(const Mat3& a, const Mat3& b) noexcept;
/// @pre `m` is regular, as every matrix between colour spaces is.
[[nodiscard]] Mat3 inverse(const Mat3& m) noexcept;
[[nodiscard]] Mat3 diagonal(const Vec3& v) noexcept;

}  // namespace nacre::spectral
