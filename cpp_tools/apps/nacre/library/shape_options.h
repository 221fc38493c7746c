// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/spectral/spectrum_shapes.h"
#include "shared/session.h"

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

/// @file
/// Shapes of a spectrum as options have them: numbers between colons.

namespace nacre::tool {

struct ShapeOptions {
    std::vector<std::string> constants, boxes, gaussians, points, spectra;
    std::string interpolation = "linear";
    std::string range = "300:850";
    double step_nm = 1.0;
};

void add_shape_options(CLI::App& command, ShapeOptions& options);

/// The sum of all shapes that are given.
/// @throws InputError with all that is wrong; the field is the option with its text.
[[nodiscard]] spectral::Spectrum spectrum_of_shapes(const ShapeOptions& options);

/// What the sum is made of, e.g. `box 450:650:1 + gaussian 550:40:0.5`.
[[nodiscard]] std::string shapes_text(const ShapeOptions& options);

}  // namespace nacre::tool
