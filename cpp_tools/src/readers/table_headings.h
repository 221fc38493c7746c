// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// @file
/// What instruments and spreadsheets call the columns of a table.

namespace nacre::spectral {

struct WavelengthHeading {
    double nm_per_unit = 1.0;
    bool unit_stated = false;
    bool is_wl = false;  ///< `wl` without a unit: µm as refractiveindex.info has it, or nm
};

/// `wavelength_nm`, `Wavelength (nm)`, `λ / µm`, `WL`, `lambda_nm`, `nm` …; nothing for a name of
/// anything else.
[[nodiscard]] std::optional<WavelengthHeading> wavelength_heading(std::string_view name);

struct ValueHeading {
    std::string name;  ///< without what says per cent
    bool per_cent = false;
};

/// `R (%)`, `%T`, `reflectance_percent` …
[[nodiscard]] ValueHeading value_heading(std::string_view name);

}  // namespace nacre::spectral
