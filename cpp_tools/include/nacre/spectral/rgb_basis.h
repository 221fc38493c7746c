// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// Reflectances of red, green and blue of Rec.709 under D65 for the 1931 observer, whose sum is 1
/// everywhere: r R(λ) + g G(λ) + b B(λ) has the colour (r, g, b). Unlike those of `SigmoidSpectrum`
/// such spectra are linear in the colour, so that they suit what is mixed or computed, and have
/// steeper flanks. After I. Mallett, C. Yuksel, Eurographics Symposium on Rendering 2019; data/cmf.
[[nodiscard]] const std::array<Sampled, 3>& rgb_basis();

}  // namespace nacre::spectral
