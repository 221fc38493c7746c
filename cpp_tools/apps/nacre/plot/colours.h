// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/spectral/colour.h"
#include "plot/canvas.h"

namespace nacre::tool {

/// Linear Rec.709 in the encoding of sRGB (IEC 61966-2-1), clipped to what a screen has.
[[nodiscard]] Paint screen_paint(const spectral::Vec3& rgb);

/// `#735244`
[[nodiscard]] std::string hexadecimal(const Paint& paint);

/// Hues of the visible spectrum between two wavelengths, for filling what is below a curve; clear
/// where nothing is seen. Lines are outside the gamut of a screen: negative channels are 0.
[[nodiscard]] std::vector<GradientStop> visible_spectrum(double first_nm, double last_nm);

}  // namespace nacre::tool
