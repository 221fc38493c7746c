// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "nacre/spectral/colour.h"
#include "nacre/spectral/named_spectrum.h"

/// @file
/// From colours to spectra that have them: many do, these are smooth ones.
///
/// RGB is linear and of a reflectance under D65 for the 1931 observer: white is (1, 1, 1). Where no
/// space is named it is Rec.709; colours of others come there through XYZ relative to D65.

namespace nacre::spectral {

/// R(λ) = 1/2 + x / (2 √(1 + x²)) of x = c0 t² + c1 t + c2, t = (λ/nm − 595) / 235: in [0, 1]
/// everywhere. Jakob and Hanika, Computer Graphics Forum 38(2), 2019.
struct SigmoidSpectrum {
    Vec3 c;

    [[nodiscard]] double at(double wavelength_nm) const noexcept;
    [[nodiscard]] Sampled on_grid() const noexcept;
    /// The same polynomial of the wavelength in nm, highest power first, as renderers store it.
    [[nodiscard]] Vec3 by_nanometre() const noexcept;
};

/// As the table of coefficients reads between its nodes: quick, and off by ΔE00 0.2 on average, 3.5
/// at most.
/// @pre every channel in [0, 1]
[[nodiscard]] SigmoidSpectrum read_sigmoid_table(const Vec3& rgb);

/// Exact: from the table by damped Gauss–Newton steps until the colour is met, to 1e-12 in nearly
/// all cases. All of Rec.709 can be met, and so can most of Rec.2020 and ACEScg.
/// @throws InputError when a number is not finite, or no such spectrum comes closer than ΔE00 0.1:
///         a colour that no reflectance has, or only one with edges.
[[nodiscard]] SigmoidSpectrum sigmoid_spectrum(const Vec3& rgb);

/// Sum of white, two of seven spectra of ten bins over 380 … 720 nm each, held beyond; B. Smits, An
/// RGB-to-spectrum conversion for reflectances, Journal of Graphics Tools 4(4), 1999. Its white is
/// that of equal energy, so under D65 colours are off by some hundredths; values reach 1.015.
/// @throws InputError unless every channel is in [0, 1].
[[nodiscard]] Sampled smits_spectrum(const Vec3& rgb);

/// ΔE00 between a colour and that of a reflectance under D65.
[[nodiscard]] double round_trip_error(const Vec3& rgb, const Sampled& reflectance);

enum class Upsampling { sigmoid, smits };

/// "jakob-hanika" or "smits". @throws InputError for any other name.
[[nodiscard]] Upsampling upsampling_from_name(std::string_view name);

/// The spectrum that a colour stands for.
struct RisenSpectrum {
    Sampled values;
    double error;                      ///< ΔE00 of the round trip
    std::optional<Vec3> coefficients;  ///< of the sigmoid, by nanometre
};

/// A light of any strength is D65 of Y = 1 through a filter: with the sigmoid that of the colour at
/// half strength, so that even a bright saturated light gets a smooth one. `error` and
/// `coefficients` are those of the filter.
/// @throws InputError as `sigmoid_spectrum` and `smits_spectrum`, and for a space that is not RGB.
[[nodiscard]] RisenSpectrum rgb_to_spectrum(const Vec3& rgb, const ColourSpace& space,
                                            Upsampling how, SpectrumKind kind);

}  // namespace nacre::spectral
