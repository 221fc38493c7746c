// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

namespace nacre::spectral {

/// A table of n and, where it is given, k as refractiveindex.info has it.
struct MediumTable {
    std::string name, references, comments;  ///< each may be empty
    std::vector<double> wavelengths_nm = {}, n = {}, k = {};
    bool has_k = false;

    void append(double nm, double n_value, double k_value)
    {
        wavelengths_nm.push_back(nm);
        n.push_back(n_value);
        k.push_back(k_value);
    }
};

[[nodiscard]] std::string medium_yaml(const MediumTable& table);

/// For the comments of a medium; empty where nothing was changed.
[[nodiscard]] std::string changes_text(std::span<const std::string> changes);

}  // namespace nacre::spectral
