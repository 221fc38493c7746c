// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "nacre/optics/film_stack.h"

/// @file
/// What a stack of layers does to light.

namespace nacre::optics {

/// Coherent stack by the recursion from the substrate up (Hirayama et al. 2001, eq. 8–11 in form
/// A18); only exp(2 i Δ), |·| ≤ 1, is ever formed, so opaque layers underflow quietly.
///
/// @param cos_ambient    cosine of the angle of incidence in the ambient, in (0, 1]
/// @param wavelength_nm  vacuum wavelength
/// @pre every layer is coherent; n > 0, k ≥ 0, thickness ≥ 0 (checked by `validate`)
[[nodiscard]] Amplitudes stack_amplitudes(const FilmStack& stack, double cos_ambient,
                                          double wavelength_nm, Polarisation polarisation);

/// Power ratios of a coherent, incoherent or mixed stack; intensities are added across layers that
/// are not coherent, as `inc_tmm` of the tmm package does, and averaged over the phases of layers
/// that have a spread.
[[nodiscard]] PowerRatios stack_power(const FilmStack& stack, double cos_ambient,
                                      double wavelength_nm, Polarisation polarisation);

/// Mean of s and p.
[[nodiscard]] PowerRatios stack_power_unpolarised(const FilmStack& stack, double cos_ambient,
                                                  double wavelength_nm);

/// What each layer absorbs of the incident power: the flux into it minus the flux out of it. In a
/// coherent stack they and T and R have the sum 1; across an incoherent layer interference of what
/// goes up and down is neglected, as in the powers themselves.
/// @pre no layer has a spread
[[nodiscard]] std::vector<double> layer_absorption(const FilmStack& stack, double cos_ambient,
                                                   double wavelength_nm, Polarisation polarisation);

/// The stack as a Gaussian band of wavelengths sees it, at the indices of its centre: each coherent
/// layer gains the spread whose phases are those of its own path over the band.
/// @param bandwidth_nm  full width at half maximum, ≥ 0
[[nodiscard]] FilmStack seen_in_band(FilmStack stack, double bandwidth_nm, double wavelength_nm);

/// Whether R and T are means, so that no amplitude stands for them.
[[nodiscard]] bool has_amplitudes(const FilmStack& stack) noexcept;

/// What is wrong with a stack, or nothing: an index that is not finite, n ≤ 0, k < 0 (gain),
/// a negative or infinite thickness or spread, an absorbing ambient, more than 64 layers.
[[nodiscard]] std::optional<StackProblem> validate(const FilmStack& stack) noexcept;

}  // namespace nacre::optics
