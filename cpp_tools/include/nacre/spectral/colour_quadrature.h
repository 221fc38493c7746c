// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "nacre/spectral/colour.h"

/// @file
/// A colour as a sum over wavelengths that do not depend on the spectrum.

namespace nacre::spectral {

/// colour[c] = Σ weight[i][c] R(wavelength_nm[i])
struct ColourQuadrature {
    std::vector<double> wavelength_nm;  ///< ascending
    std::vector<Vec3> weight;
};

/// The sum of `weights` itself: 471 wavelengths.
[[nodiscard]] ColourQuadrature nanometre_quadrature(const ColourWeights& weights);

/// Every `step_nm`, the weights being linear between those at 1 nm: the truth that others are
/// measured against. @pre 0 < step_nm ≤ 1
[[nodiscard]] ColourQuadrature fine_quadrature(const ColourWeights& weights, double step_nm);

/// Stepping: every `step_nm` with the weights that happen to be there times the step, from the
/// first wavelength ≥ `from_nm` that has a weight. What lies between, lines of a lamp above all, is
/// missed; even white changes its colour. @pre 1 ≤ step_nm ≤ kLargestStepNm
inline constexpr int kLargestStepNm = 128;
[[nodiscard]] ColourQuadrature stepped_quadrature(const ColourWeights& weights, int step_nm,
                                                  int from_nm = kFirstNm);

/// Hierarchy: the 512 nanometres from 324 to 835 nm in cells of 2^level; a cell has the sum of its
/// weights, so that white stays white, and its spectrum is read in the middle, or at the nearer end
/// of 360 … 830 nm. Cells without weight are left out. @pre 0 ≤ level ≤ kHighestLevel
inline constexpr int kHighestLevel = 9;
[[nodiscard]] ColourQuadrature hierarchical_quadrature(const ColourWeights& weights, int level);

/// The one of a name: "full" (1 nm), "reference" (0.05 nm), "steps:N" or "hierarchical:LEVEL";
/// nothing for "adaptive", where wavelengths depend on what is summed. Steps are counted from
/// `from_nm`, where what is summed begins.
/// @throws InputError for any other name, or a number out of range
[[nodiscard]] std::optional<ColourQuadrature> named_quadrature(std::string_view name,
                                                               const ColourWeights& weights,
                                                               int from_nm = kFirstNm);

/// Σ weight R; `values` as `quadrature.wavelength_nm`.
[[nodiscard]] Vec3 quadrature_sum(const ColourQuadrature& quadrature,
                                  const std::vector<double>& values) noexcept;

}  // namespace nacre::spectral
