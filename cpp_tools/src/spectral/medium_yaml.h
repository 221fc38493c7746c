// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace nacre::spectral {

/// A table of n and, where it is given, k as refractiveindex.info has it.
struct MediumTable {
    std::string name, references;  ///< either may be empty
    const std::vector<double>& wavelengths_nm;
    const std::vector<double>& n;
    const std::vector<double>* k = nullptr;
};

[[nodiscard]] std::string medium_yaml(const MediumTable& table);

}  // namespace nacre::spectral
