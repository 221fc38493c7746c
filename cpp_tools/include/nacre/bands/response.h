// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "nacre/bands/bands.h"

/// @file
/// Bands that are there already, as somebody else sees them, or lit by another light.

namespace nacre::bands {

/// Three sensitivities at a wavelength in nm.
using Sensor = std::function<spectral::Vec3(double wavelength_nm)>;

/// What each band is to a sensor: ∫ s dλ over the band of an emission of 1 per nm; of a line as
/// wide as the band, s at the line.
[[nodiscard]] std::vector<spectral::Vec3> responses(const Bands& bands, const Sensor& sensor);

/// The same bands to another observer: their colours, not where they lie.
[[nodiscard]] Bands seen_by(const Bands& bands, spectral::ObserverId observer);

/// From edges and wavelengths, as a file has them; a band that is no line is of all its
/// wavelengths.
/// @throws InputError unless edges ascend from 360 to 830 nm, or as near as steps of 0.1 nm are,
/// and
///         each wavelength is within its band
[[nodiscard]] Bands bands_of(std::span<const double> edges_nm,
                             std::span<const double> wavelength_nm,
                             const std::vector<bool>& is_line, spectral::ObserverId observer);

/// Around wavelengths that ascend: edges half way between neighbours.
/// @throws InputError where two are nearer to each other than 0.1 nm, or there are more than
///         kMostBands
[[nodiscard]] Bands bands_around(std::span<const double> wavelength_nm,
                                 spectral::ObserverId observer);

/// By how much light in each band changes when one light takes the place of another; both have a
/// luminance of 1. 0 where neither shines.
/// @throws InputError where the new one shines and the old one does not: what the picture does not
///         have cannot be made
[[nodiscard]] std::vector<double> exchange(const Bands& bands, std::span<const double> power,
                                           std::string_view name, const Light& light);

}  // namespace nacre::bands
