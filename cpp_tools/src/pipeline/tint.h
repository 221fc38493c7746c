// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/spectral/wavelength_sampling.h"

namespace nacre::pipeline {

/// lut::tint_basis for tints in the space of `weights`, of a metal of this reflectance.
[[nodiscard]] std::vector<spectral::Vec3> tint_basis(const spectral::WavelengthSampling& sampling,
                                                     const spectral::ColourWeights& weights,
                                                     const spectral::Sampled& reflectance);

}  // namespace nacre::pipeline
