// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/bands/bands.h"
#include "nacre/spectral/camera.h"
#include "nacre/spectral/colour.h"

/// @file
/// From bands to a colour: who looks, what is white to them, and in which space.

namespace nacre::tool {

struct Viewer {
    spectral::ObserverId observer = spectral::ObserverId::cie1931;
    std::optional<spectral::Camera> camera;  ///< in place of an eye
    bool raw = false;                        ///< of a camera: its channels, balanced alone
    /// What is white, in each band; without it an eye adapts to nothing, and a camera to D65.
    std::optional<std::vector<double>> white;
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    double exposure = 0.0;  ///< in stops
};

/// The colour of a radiance of 1 per nm in each band, in the space; white has a luminance of 1
/// where it has that to the eye.
///
/// A camera's channels are balanced by its white, and then, unless they are raw, taken to XYZ by
/// the matrix that fits the reflectances of the library under that white best (least squares),
/// white itself exactly.
/// @throws InputError where white has nothing that one of the channels sees
[[nodiscard]] std::vector<spectral::Vec3> colours_of_bands(const bands::Bands& bands,
                                                           const Viewer& viewer,
                                                           const spectral::ColourSpace& space);

/// Σ values × colours.
[[nodiscard]] spectral::Vec3 summed(const std::vector<double>& values,
                                    const std::vector<spectral::Vec3>& colours);

}  // namespace nacre::tool
