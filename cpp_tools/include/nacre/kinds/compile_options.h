// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "nacre/media/working_range.h"
#include "nacre/spectral/colour.h"

namespace nacre::kinds {

/// How a material is compiled, whatever it is.
struct CompileOptions {
    std::string illuminant = "D65";
    spectral::ObserverId observer = spectral::ObserverId::cie1931;
    /// None: tables alone, which then have the colour of the light in them.
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    std::string space = "lin_rec709_scene";
    /// Instead of `space`: a scene-linear space that the library does not know by name.
    std::optional<spectral::ColourSpace> custom_space;
    spectral::RangeRule range = spectral::RangeRule::hold_ends;  ///< of the media's data
    double tolerance = 0.1;                                      ///< ΔE00
    std::function<bool(double)> progress;

    /// Weights of each wavelength in a colour of these options.
    [[nodiscard]] spectral::ColourWeights weights() const;
};

}  // namespace nacre::kinds
