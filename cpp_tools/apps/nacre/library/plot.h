// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/media/optical_constants.h"
#include "nacre/spectral/named_spectrum.h"
#include "plot/frame.h"

namespace nacre::tool {

/// The curve over the visible spectrum with the colour: of a reflectance under D65, of an emission
/// its chromaticity, as bright as a screen has it.
[[nodiscard]] Plot plot_of(const spectral::NamedSpectrum& spectrum);

/// n and, where it absorbs, k; the colour in which a surface that absorbs reflects.
[[nodiscard]] Plot plot_of(const spectral::Medium& medium);

}  // namespace nacre::tool
