// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/bands/fine_grid.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::bands {

/// Reflectances of the shipped library whose key begins with `prefix`.
inline std::vector<Fine> shipped_reflectances(std::string_view prefix = "")
{
    std::vector<Fine> found;
    for (const std::string& key : spectral::library_spectrum_keys())
        if (key.starts_with(prefix) &&
            spectral::library_spectrum(key).kind == spectral::SpectrumKind::reflectance)
            found.push_back(spectral::library_spectrum(key).values_at(fine_grid()));
    return found;
}

}  // namespace nacre::bands
