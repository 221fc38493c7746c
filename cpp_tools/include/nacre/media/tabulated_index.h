// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/media/dispersion_formula.h"
#include "nacre/media/optical_constants.h"

namespace nacre::spectral {

/// Samples over wavelength in µm, ascending; linear in between.
struct IndexTable {
    std::vector<double> wavelengths_um, values;

    [[nodiscard]] double at(double wavelength_um) const;
    [[nodiscard]] std::array<double, 2> range_um() const noexcept;
};

/// A formula and where its authors say that it holds.
struct RangedFormula {
    DispersionFormula formula;
    std::array<double, 2> range_um;
};

/// What a file of refractiveindex.info states: n by table or formula, and perhaps k.
struct MeasuredIndex {
    std::string name;  ///< for messages
    std::variant<IndexTable, RangedFormula> n;
    std::optional<IndexTable> k;  ///< none: transparent
};

/// @throws InputError when the ranges of n and k have nothing in common.
[[nodiscard]] OpticalConstantsPtr measured_constants(MeasuredIndex index);

}  // namespace nacre::spectral
