// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/named_spectrum.h"

/// @file
/// Lights by what a user calls them.

namespace nacre::spectral {

/// By text: a name of `illuminant_names()`, whose tables come from data/spd;
/// the key of an emission in the library of spectra, `lamp/hps`; or one of `kIlluminantForms`:
/// `blackbody:3200`, `daylight:5600`, `line:589.3`, `line:435.8@1,546.1@0.8`.
/// @throws InputError for anything else; the message lists names and forms.
[[nodiscard]] Illuminant named_illuminant(std::string_view text);
/// The same light with the samples that make it up, which go beyond the grid: tables as they were
/// published, black bodies from 300 to 900 nm. Its name and key are `text`.
/// @throws InputError as named_illuminant()
[[nodiscard]] NamedSpectrum light_spectrum(std::string_view text);
/// The lines of `line:…`, which have no width; none for any other light.
/// @throws InputError as named_illuminant() where the text begins with `line:`
[[nodiscard]] std::vector<SpectralLine> named_lines(std::string_view text);
inline constexpr std::string_view kIlluminantForms =
    "a light of the library (lamp/hps), blackbody:<K>, daylight:<K>, "
    "line:<nm>[@<power>][,<nm>[@<power>]…]";

}  // namespace nacre::spectral
