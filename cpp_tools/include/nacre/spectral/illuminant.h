// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/spectrum.h"
#include "nacre/spectral/wavelengths.h"

/// @file
/// Lights: the tables of the CIE, Planck's law, daylight, lines.

namespace nacre::spectral {

/// Relative spectral power on the 1 nm grid.
struct Illuminant {
    std::string name;
    Sampled power;
};

/// CIE E, A, B, C, D50, D55, D65, D75, F1 … F12, LED-B1 … LED-V2.
[[nodiscard]] std::vector<std::string> illuminant_names();

/// The samples of one of them as they were published in data/spd (E is 1 everywhere); nothing for
/// any other name.
[[nodiscard]] std::optional<Spectrum> illuminant_samples(std::string_view name);

/// Who published them, and on which terms.
struct IlluminantCitation {
    std::string references, licence;
};
/// @pre `name` is one of illuminant_names()
[[nodiscard]] IlluminantCitation illuminant_citation(std::string_view name);

/// The CIE defines its illuminants between the published samples by linear interpolation.
/// @throws InputError for what is none of illuminant_names()
[[nodiscard]] Illuminant cie_illuminant(std::string_view name);

struct SpectralLine {
    double wavelength_nm, power;
};

/// Infinitely narrow lines. One between two points of the grid is shared by both, so that sums over
/// the grid read a function linearly at the line.
/// @throws InputError when there is none, one is outside the grid, or a power is not finite and >
/// 0.
[[nodiscard]] Illuminant line_spectrum(const std::vector<SpectralLine>& lines);
/// The samples behind it, which are 0 beside the grid.
[[nodiscard]] Spectrum line_samples(const std::vector<SpectralLine>& lines);

/// Planck's law with c2 = 1.4388e-2 m K (CIE 015), scaled to 100 at 560 nm.
/// @throws InputError outside 100 … 1e6 K.
[[nodiscard]] Illuminant blackbody(double kelvin);
/// From 300 to 900 nm, every 1 nm.
[[nodiscard]] Spectrum blackbody_samples(double kelvin);

/// CIE D-series, CIE 015:2018 4.1.2, from its correlated colour temperature (D65 has 6504 K).
/// @throws InputError outside 4000 … 25 000 K.
[[nodiscard]] Illuminant daylight(double kelvin);
/// At the wavelengths of the published components.
[[nodiscard]] Spectrum daylight_samples(double kelvin);

}  // namespace nacre::spectral
