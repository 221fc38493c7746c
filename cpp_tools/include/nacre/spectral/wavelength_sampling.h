// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "nacre/spectral/colour.h"

/// @file
/// One wavelength per path: how it is drawn, and the colour that a path of this wavelength carries.

namespace nacre::spectral {

/// Inverse CDF over equal cells of a uniform number u in [0, 1): cell i holds u in [i, i+1)/N and
/// wavelengths [edges_nm[i], edges_nm[i+1]), uniform inside. `weight[i]` is the mean over the cell
/// of (colour weight / density), so that the mean of all weights is exactly (1, 1, 1), the colour
/// of white, in an RGB space. Signed: single wavelengths lie outside every RGB gamut.
struct WavelengthSampling {
    std::vector<double> edges_nm;  ///< N + 1, ascending
    std::vector<Vec3> weight;      ///< N
};

/// In every shader. In the green they are below 4 nm wide, finer than a colour can tell.
inline constexpr int kWavelengthCells = 64;

/// Fewer could not keep every cell within 40 nm.
inline constexpr int kFewestCells = 12;

/// The density follows Σ_c |weight_c(λ)| of `weights` (what the eye and the light make of a
/// wavelength), mixed with a small uniform part so that no cell is wider than 40 nm.
/// @pre cells ≥ kFewestCells
[[nodiscard]] WavelengthSampling sample_wavelengths(const ColourWeights& weights, int cells);

}  // namespace nacre::spectral
