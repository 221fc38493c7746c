// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace nacre::spectral {

/// One of the nine dispersion formulas of refractiveindex.info ("Dispersion formulas", 2024).
struct DispersionFormula {
    int number;                        ///< 1 … 9
    std::vector<double> coefficients;  ///< C1, C2, … as the file lists them, λ in µm

    /// n², n or n − 1 turned into n; NaN where the formula has no real answer.
    [[nodiscard]] double index_at(double wavelength_um) const noexcept;
};

/// What is wrong with the number of coefficients; empty when nothing is.
[[nodiscard]] std::string coefficient_count_problem(int formula, std::size_t count);

}  // namespace nacre::spectral
