// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/spectrum_files.h"

namespace nacre::spectral {

/// `cie/` and a name of illuminant_names().
[[nodiscard]] bool is_illuminant_key(std::string_view key);
[[nodiscard]] std::vector<std::string> illuminant_keys();

/// The samples as they were published. @pre is_illuminant_key(key)
[[nodiscard]] NamedSpectrum illuminant_entry(std::string_view key);

/// The spectra behind blackbody(), daylight() and line_spectrum().
[[nodiscard]] Spectrum blackbody_samples(double kelvin);
[[nodiscard]] Spectrum daylight_samples(double kelvin);
[[nodiscard]] Spectrum line_samples(const std::vector<SpectralLine>& lines);

}  // namespace nacre::spectral
