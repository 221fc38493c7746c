// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/matrix.h"
#include "nacre/spectral/spectrum.h"

/// @file
/// What a camera makes of wavelengths.

namespace nacre::spectral {

/// Relative sensitivities of red, green and blue, ≥ 0; nothing beyond their samples.
struct Camera {
    std::string name;
    std::vector<Spectrum> sensitivity;  ///< three

    /// Linear between samples, 0 beyond.
    [[nodiscard]] Vec3 at(double wavelength_nm) const;
};

/// Keys of those of data/cameras: `nikon-d5100`.
[[nodiscard]] std::vector<std::string> camera_keys();

/// One of them. @throws InputError for any other key; the message lists the keys.
[[nodiscard]] Camera camera(std::string_view key);

}  // namespace nacre::spectral
