// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nacre/spectral/colour.h"

namespace nacre::kinds {

/// Text of `nacre_colour_tables.h`, which gives hand-written shaders their colours. The file that
/// ships has those of default_colour_weights(); a compiled shader has those of its options.
[[nodiscard]] std::string colour_tables_header(const spectral::ColourWeights& weights);

/// Text of `nacre_constants.h`: what gratings mean and allow, for shaders.
[[nodiscard]] std::string constants_header();

/// Linear Rec.709, D65, CIE 1931.
[[nodiscard]] spectral::ColourWeights default_colour_weights();

}  // namespace nacre::kinds
