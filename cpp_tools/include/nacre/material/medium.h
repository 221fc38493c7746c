// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "nacre/material/section.h"

/// @file
/// A medium as a template names or describes it. Looking it up needs the library and belongs to
/// nacre/kinds.

namespace nacre::material {

/// medium = "Fe/Johnson"
struct LibraryMedium {
    std::string key;
    bool operator==(const LibraryMedium&) const = default;
};

/// n = 1.33, k = 0.0
struct ConstantMedium {
    double n = 1.0, k = 0.0;
    bool operator==(const ConstantMedium&) const = default;
};

/// cauchy = [a, b, c], λ in µm; one to three coefficients
struct CauchyMedium {
    std::vector<double> coefficients;
    double k = 0.0;
    bool operator==(const CauchyMedium&) const = default;
};

/// sellmeier = { b = […], c = […] }, C in µm²
struct SellmeierMedium {
    std::vector<double> b, c;
    bool operator==(const SellmeierMedium&) const = default;
};

/// abbe = { n_d = 1.5168, v_d = 64.17 }
struct AbbeMedium {
    double n_d = 1.5, v_d = 60.0;
    bool operator==(const AbbeMedium&) const = default;
};

/// A medium, and where the template names it, for messages.
struct MediumSpec {
    std::variant<LibraryMedium, ConstantMedium, CauchyMedium, SellmeierMedium, AbbeMedium> value;
    int line = 0;
    std::string field;  ///< e.g. `layer[2].medium`

    /// Whether it says so itself; of a medium of the library it is not known here.
    [[nodiscard]] bool absorbs() const;
};

/// Reads the one of `medium`, `n`, `cauchy`, `sellmeier`, `abbe` that the section must hold.
[[nodiscard]] MediumSpec read_medium(Section& section);

/// The same from a section of its own, which the parent must have.
[[nodiscard]] MediumSpec read_medium_at(Section& parent, std::string_view key);

}  // namespace nacre::material
