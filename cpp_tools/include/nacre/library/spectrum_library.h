// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/named_spectrum.h"

/// @file
/// Named spectra: those that come with Nacre and the user's own.

namespace nacre::spectral {

/// One spectrum by its key, e.g. `colorchecker/dark-skin`; its kind is stated. Thread-safe; the
/// reference stays valid.
/// @throws InputError for an unknown key; the message names near matches.
[[nodiscard]] const NamedSpectrum& library_spectrum(std::string_view key);

/// Of both libraries, ascending.
[[nodiscard]] std::vector<std::string> library_spectrum_keys();

}  // namespace nacre::spectral
