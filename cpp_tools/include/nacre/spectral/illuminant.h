// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/spectrum_files.h"
#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// Relative spectral power on the 1 nm grid.
struct Illuminant {
    std::string name;
    Sampled power;
};

/// By text: a name of `illuminant_names()`, whose tables come from data/spd (E is 1 everywhere);
/// the key of an emission in the library of spectra, `lamp/hps`; or one of `kIlluminantForms`:
/// `blackbody:3200`, `daylight:5600`, `line:589.3`, `line:435.8@1,546.1@0.8`.
/// @throws InputError for anything else; the message lists names and forms.
[[nodiscard]] Illuminant named_illuminant(std::string_view text);
/// The same light with the samples that make it up, which go beyond the grid: tables as they were
/// published, black bodies from 300 to 900 nm. Its name and key are `text`.
/// @throws InputError as named_illuminant()
[[nodiscard]] NamedSpectrum light_spectrum(std::string_view text);
inline constexpr std::string_view kIlluminantForms =
    "a light of the library (lamp/hps), blackbody:<K>, daylight:<K>, "
    "line:<nm>[@<power>][,<nm>[@<power>]…]";
/// CIE E, A, B, C, D50, D55, D65, D75, F1 … F12, LED-B1 … LED-V2.
[[nodiscard]] std::vector<std::string> illuminant_names();

struct SpectralLine {
    double wavelength_nm, power;
};

/// Infinitely narrow lines. One between two points of the grid is shared by both, so that sums over
/// the grid read a function linearly at the line.
/// @throws InputError when there is none, one is outside the grid, or a power is not finite and >
/// 0.
[[nodiscard]] Illuminant line_spectrum(const std::vector<SpectralLine>& lines);

/// Planck's law with c2 = 1.4388e-2 m K (CIE 015), scaled to 100 at 560 nm.
/// @throws InputError outside 100 … 1e6 K.
[[nodiscard]] Illuminant blackbody(double kelvin);

/// CIE D-series, CIE 015:2018 4.1.2, from its correlated colour temperature (D65 has 6504 K).
/// @throws InputError outside 4000 … 25 000 K.
[[nodiscard]] Illuminant daylight(double kelvin);

}  // namespace nacre::spectral
