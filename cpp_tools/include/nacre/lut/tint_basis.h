// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nacre/spectral/colour.h"
#include "nacre/spectral/wavelength_sampling.h"

/// @file
/// What a coloured metal does to light of one wavelength that stands for a colour.

namespace nacre::lut {

/// Cells of wavelengths with the signed colours that paths of them carry; their mean is the white.
struct WavelengthCells {
    std::vector<double> nm;              ///< centres, ascending
    std::vector<spectral::Vec3> weight;  ///< in linear Rec.709
    std::vector<double> reflectance;     ///< of the metal, in [0, 1]
};

/// One triple for each cell. A path that meets the metal in the colour `tint` is weakened by the
/// number tint · basis of its cell. A signed weight times a colour would do the same in the mean,
/// but has a negative sum where the colour is saturated, and renderers drop such a lobe. Here
///  - the mean over the cells of weight · (tint · basis) is the tint, for every tint;
///  - the metal's own colour gives its own reflectance in every cell;
///  - no tint of Rec.709 gives less than nothing, as long as light and metal have all wavelengths:
///    of light that is a few lines the conditions cannot be met, and come out as well as can be.
///
/// Source: three smooth spectra that add up to one, as of Mallett and Yuksel 2019, Spectral Primary
/// Decomposition for Rendering with sRGB Reflectance, EGSR; here times the metal's reflectance.
/// @pre the lists are equally long, ≥ 4
[[nodiscard]] std::vector<spectral::Vec3> tint_basis(const WavelengthCells& cells);

/// The same in the space of `weights`, for what a metal reflects at every wavelength.
[[nodiscard]] std::vector<spectral::Vec3> tint_basis(const spectral::WavelengthSampling& sampling,
                                                     const spectral::ColourWeights& weights,
                                                     const spectral::Sampled& reflectance);

}  // namespace nacre::lut
