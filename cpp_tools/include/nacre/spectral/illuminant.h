// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// Relative spectral power on the 1 nm grid.
struct Illuminant {
    std::string name;
    Sampled power;
};

/// "E", "A", "D65", "D50", "D55", "D75"; tables from data/spd, E is 1 everywhere.
/// @throws InputError for an unknown name; the message lists the names.
[[nodiscard]] Illuminant named_illuminant(std::string_view name);
[[nodiscard]] std::vector<std::string> illuminant_names();

/// Planck's law with c2 = 1.4388e-2 m K (CIE 015), scaled to 100 at 560 nm.
/// @throws InputError outside 100 … 1e6 K.
[[nodiscard]] Illuminant blackbody(double kelvin);

/// CIE D-series, CIE 015:2018 4.1.2, from its correlated colour temperature (D65 has 6504 K).
/// @throws InputError outside 4000 … 25 000 K.
[[nodiscard]] Illuminant daylight(double kelvin);

}  // namespace nacre::spectral
