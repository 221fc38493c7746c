// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/core/table_role.h"

namespace nacre::lut {

/// One axis of a table: the centres of the edge texels hold `min` and `max`, linear in between.
struct Axis {
    std::string name;  ///< `cos_theta`, `thickness_nm`, `thickness_scale`, …
    std::string unit;  ///< `1`, `nm`, …
    double min, max;
    int texels;

    [[nodiscard]] double at(int texel) const noexcept;  ///< value at a texel centre
};

inline constexpr int kFloatBits = 23;

/// The nearest number with so many bits of mantissa after the leading one. Below 1/32 the step is
/// that of 1/32: dark colours need not be better in proportion, and files of equal steps are small.
[[nodiscard]] double rounded_texel(double value, int bits) noexcept;

/// A baked two-dimensional table, row-major; row 0 (the top row of the image) holds `y.min`.
struct Table {
    TableRole role;
    std::string quantity;               ///< `reflectance`, `transmittance`
    Axis x, y;                          ///< y.texels is 1 where nothing but the angle varies
    std::vector<std::string> channels;  ///< `R`, `G`, `B`
    std::vector<float> texels;          ///< y.texels * x.texels * channels.size()
    /// ΔE00 between texels against the exact value for angles up to 87° (cosθ ≥ 0.05): largest
    /// probe.
    double error_max = 0.0;
    double error_mean = 0.0;          ///< the same, mean over the probes
    std::string error_unit = "dE00";  ///< `1`: of the numbers themselves
    /// Of a third axis, roughness: so many tables side by side along x, see rough_tables.h.
    int slices = 1;
    /// Of the mantissa, without the leading one, that texels were rounded to.
    int texel_bits = kFloatBits;
    /// 2: so many slices again follow, seen from inside the glass, see rough_glass_tables.h.
    int sides = 1;

    [[nodiscard]] const std::string& name() const { return table_name(role); }
};

}  // namespace nacre::lut
