// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "nacre/bands/bands.h"
#include "nacre/spectral/camera.h"
#include "nacre/spectral/colour.h"

/// @file
/// From bands to colours: who looks, and what is white to them.

namespace nacre::bands {

struct Viewer {
    spectral::ObserverId observer = spectral::ObserverId::cie1931;
    std::optional<spectral::Camera> camera{};  ///< in place of an eye
    bool raw = false;                          ///< of a camera: its channels, balanced alone
    /// What is white, in each band; without it an eye adapts to nothing, and a camera to D65.
    std::optional<std::vector<double>> white{};
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    double exposure = 0.0;  ///< in stops
};

/// The colour of a radiance of 1 per nm in each band: XYZ relative to D65, of which white has Y = 1
/// where it has that to the eye; or of a raw camera its channels.
///
/// A camera's channels are balanced by its white, and then, unless they are raw, taken to XYZ by
/// the matrix that fits the reflectances of the library under that white best (least squares),
/// white itself exactly.
/// @param way_out  as spectral::adaptation()
/// @throws InputError where white is black, or has nothing that one of the channels sees
/// @pre white has a value for each band
[[nodiscard]] std::vector<spectral::Vec3> colours_of_bands(const Bands& bands, const Viewer& viewer,
                                                           std::string_view way_out = "");

/// Σ values × colours.
[[nodiscard]] spectral::Vec3 summed(std::span<const double> values,
                                    std::span<const spectral::Vec3> colours);

/// How far two places fall apart under a light.
struct Metamerism {
    double difference;  ///< ΔE00
    /// Special index of metamerism for a change in illuminant (CIE 015:2018): ΔE00 where the second
    /// is first multiplied, channel by channel of XYZ, so that both are alike as they are lit.
    double index;
};

/// White is what has a luminance of 1.
/// @param first, second  radiance per nm in each band, lit by `power`
/// @param name           of that light, for messages
/// @throws InputError as exchange()
[[nodiscard]] Metamerism metamerism(const Bands& bands, std::span<const double> first,
                                    std::span<const double> second, std::span<const double> power,
                                    std::string_view name, const Light& light);

}  // namespace nacre::bands
