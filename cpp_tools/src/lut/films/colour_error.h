// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "nacre/spectral/colour.h"

namespace nacre::lut {

/// ΔE00 between two colours of a space that is a matrix away from XYZ, against D65 white. Colours
/// outside the gamut count as they are: L*a*b* goes on linearly below zero.
class ColourError {
public:
    explicit ColourError(const spectral::Mat3& to_xyz_d65) : to_xyz_(to_xyz_d65) {}

    [[nodiscard]] double operator()(const spectral::Vec3& a,
                                    const spectral::Vec3& b) const noexcept;

private:
    spectral::Mat3 to_xyz_;
};

/// Of a table whose errors nobody asked for.
inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// Maximum and mean of many errors.
struct ErrorStatistics {
    double max = 0.0, sum = 0.0;
    std::size_t count = 0;

    void add(double error)
    {
        max = std::max(max, error);
        sum += error;
        ++count;
    }
    void add(const ErrorStatistics& other)
    {
        max = std::max(max, other.max);
        sum += other.sum;
        count += other.count;
    }
    [[nodiscard]] double mean() const
    {
        return count == 0 ? 0.0 : sum / static_cast<double>(count);
    }
};

}  // namespace nacre::lut
