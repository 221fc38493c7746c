// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/lut/film_request.h"

/// @file
/// Light that leaves a rough film after two and more bounces.

namespace nacre::lut {

/// Columns over cos_theta of each slice: what further bounces add is smooth.
inline constexpr std::size_t kFurtherColumns = 9;

/// Colours at [slice][column] of each of `rows` equal steps of the variation.
class FurtherBounces {
public:
    FurtherBounces(const FilmTableRequest& request, std::size_t rows);

    [[nodiscard]] const spectral::Vec3& at(std::size_t slice, std::size_t column,
                                           std::size_t row) const;
    /// Linear between columns, and between slices counted from 1; slice 0 is smooth and has none.
    [[nodiscard]] spectral::Vec3 read(double slice, double cos_theta, std::size_t row) const;

private:
    std::vector<spectral::Vec3> colours_;
};

}  // namespace nacre::lut
