// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/kinds/compile_options.h"
#include "nacre/oslgen/program.h"
#include "nacre/spectral/wavelength_sampling.h"

namespace nacre::kinds {

/// λ(u) and its weights, as every shader has them that draws a wavelength for each path.
[[nodiscard]] spectral::WavelengthSampling path_wavelengths(const spectral::ColourWeights& weights);

/// Its parameters.
[[nodiscard]] std::vector<oslgen::Constant> wavelength_constants(
    const spectral::WavelengthSampling& sampling);

}  // namespace nacre::kinds
