// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/media/optical_constants.h"

/// @file
/// A stack whose thicknesses and angle are free, over all wavelengths.

namespace nacre::optics {

/// Media and coherence of a stack whose thicknesses and angle are free.
struct DispersiveStack {
    /// From the ambient to the substrate; up to 1e-5 of the ambient's k is dropped.
    std::vector<spectral::OpticalConstantsPtr> media;
    std::vector<bool> coherent;  ///< one flag a layer: media.size() − 2
};

/// Light at one angle.
struct ObliqueLight {
    double cos_ambient;       ///< in (0, 1]
    double share_of_s = 0.5;  ///< 0.5: unpolarised; 1: s; 0: p
};

}  // namespace nacre::optics
