// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/named_spectrum.h"

/// @file
/// The illuminants of the CIE as entries of the library of spectra.

namespace nacre::spectral {

/// `cie/` and a name of illuminant_names().
[[nodiscard]] bool is_illuminant_key(std::string_view key);
[[nodiscard]] std::vector<std::string> illuminant_keys();

/// The samples as they were published. @pre is_illuminant_key(key)
[[nodiscard]] NamedSpectrum illuminant_entry(std::string_view key);

}  // namespace nacre::spectral
