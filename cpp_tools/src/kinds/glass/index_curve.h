// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

namespace nacre::kinds::glass {

/// An index over 360 … 830 nm as a polynomial in x = slope / λ + offset, which runs from −1 to 1:
/// what nodes can compute of any clear medium.
struct IndexCurve {
    double slope_nm, offset;
    std::vector<double> power;  ///< of x, from the constant on
    double error;               ///< the largest, of every nanometre
};

/// Of the least degree, up to 12, that is within 1e-6. The poles of a clear medium lie well outside
/// in 1/λ: a flint takes degree 8.
/// @param index  at a wavelength in nm
[[nodiscard]] IndexCurve index_curve(const std::function<double(double)>& index);

}  // namespace nacre::kinds::glass
