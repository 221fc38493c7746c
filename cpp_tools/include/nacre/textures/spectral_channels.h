// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nacre/spectral/named_spectrum.h"

/// @file
/// Names of channels in spectral images: "An OpenEXR Layout for Spectral Images", A. Fichet,
/// R. Pacanowski, A. Wilkie, Journal of Computer Graphics Techniques 10(3), 2021.

namespace nacre::spectral {

struct SpectralChannel {
    SpectrumKind kind;  ///< `T.…`: reflectance or transmittance; `S0.…`: emission
    double wavelength_nm;
};

/// `S0.` or `T.` and a wavelength or frequency with its unit, a comma for the decimal point:
/// `T.550,000000nm`, `S0.5,5e2nm`, `S0.545THz`. Nothing for any other name, the other Stokes
/// components among them.
[[nodiscard]] std::optional<SpectralChannel> parse_spectral_channel(std::string_view name);

/// `T.550,000000nm`, as the authors' tools write it.
[[nodiscard]] std::string spectral_channel_name(const SpectralChannel& channel);

/// Version of the layout, and the units of emissions that are relative.
inline constexpr std::string_view kSpectralLayoutVersion = "1.0";
inline constexpr std::string_view kSpectralEmissiveUnits = "W.m^-2.sr^-1";

}  // namespace nacre::spectral
