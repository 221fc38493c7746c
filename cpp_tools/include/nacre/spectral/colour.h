// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/matrix.h"
#include "nacre/spectral/observer.h"

/// @file
/// From spectra to numbers that a screen or a renderer takes.

namespace nacre::spectral {

/// Emission: k = 1 / Σ ȳ, so an equal-energy spectrum of 1 has Y = 1.
[[nodiscard]] Vec3 emission_to_xyz(const Sampled& radiance, ObserverId observer);

/// Reflectance or transmittance: k = 1 / Σ S ȳ, so a perfect white has Y = 1.
[[nodiscard]] Vec3 reflectance_to_xyz(const Sampled& reflectance, const Illuminant& illuminant,
                                      ObserverId observer);

[[nodiscard]] std::array<double, 2> xyz_to_xy(const Vec3& xyz) noexcept;

/// XYZ of a perfect white under a light: its Y is 1.
[[nodiscard]] Vec3 white_under(const Illuminant& illuminant, ObserverId observer);

/// CIE 1976 L*a*b*; `white` is the XYZ of a perfect white.
[[nodiscard]] Vec3 xyz_to_lab(const Vec3& xyz, const Vec3& white) noexcept;

/// CIEDE2000 (Sharma, Wu, Dalal 2005), kL = kC = kH = 1.
[[nodiscard]] double delta_e_2000(const Vec3& lab_a, const Vec3& lab_b) noexcept;

/// Correlated colour temperature and distance from the Planckian locus, positive above it: the
/// nearest point of the locus in CIE 1960 uv, 2 degree observer, found by search (Ohno 2013
/// approximates the same definition).
/// Its XYZ are those of the 2 degree observer.
struct ColourTemperature {
    double cct_kelvin, duv;
};
/// Nothing where the chromaticity is too far from the locus to have one (|duv| > 0.05), or nearest
/// to a temperature outside 1000 … 100 000 K.
[[nodiscard]] std::optional<ColourTemperature> colour_temperature(const Vec3& xyz);

enum class Adaptation {
    bradford,  ///< Lam 1985, as in ICC.1:2022
    cat16,     ///< Li et al. 2017, complete
    none,
};

/// "bradford", "cat16" or "none". @throws InputError for any other name.
[[nodiscard]] Adaptation adaptation_from_name(std::string_view name);
[[nodiscard]] std::string adaptation_name(Adaptation how);

/// Takes colours under one white, given as XYZ, to another: von Kries factors on cone responses.
/// @param way_out  ends the message: how the caller's user asks for no adaptation
/// @throws InputError when a cone response of `from_white` is not > 0, as of a line of sodium.
[[nodiscard]] Mat3 adaptation(Adaptation how, const Vec3& from_white, const Vec3& to_white,
                              std::string_view way_out = "");

/// A scene-linear space that is a matrix away from XYZ. The XYZ side is relative to D65 (the
/// `cie_xyz_d65_interchange` of OpenColorIO): D65 is (1, 1, 1) in every RGB space here, as it is
/// in Blender, and a space whose own white is another one (ACEScg) has a Bradford step inside.
struct ColourSpace {
    std::string name;  ///< lin_rec709_scene, lin_rec2020_scene, lin_ap1_scene, xyz_d65
    Mat3 from_xyz_d65, to_xyz_d65;
    std::optional<std::array<double, 8>> chromaticities;  ///< rx ry gx gy bx by wx wy; none for XYZ
};

/// @throws InputError for an unknown name; the message lists the names.
[[nodiscard]] const ColourSpace& colour_space(std::string_view name);
[[nodiscard]] std::vector<std::string> colour_space_names();

/// CIE xy of D65 as the RGB spaces define their white: (0.3127, 0.3290).
[[nodiscard]] Vec3 d65_white() noexcept;

/// The XYZ that L*a*b* of an emission is relative to: D65 of Y = 1 as the observer sees it; to the
/// 2 degree observer d65_white().
[[nodiscard]] Vec3 emission_white(ObserverId observer);
/// Takes the XYZ of an emission to XYZ relative to D65. An emission is not adapted, but the spaces
/// are defined by the 2 degree observer: to another one D65 light has to be their white as well,
/// by Bradford.
[[nodiscard]] Mat3 emission_to_d65(ObserverId observer);

/// Turns a reflectance spectrum into a colour by one weighted sum: rgb[c] = Σ weight[c][i] R[i].
/// Holds observer, illuminant, adaptation to D65 and the space's matrix; Σ weight[c] = 1 in an RGB
/// space, so that a perfect white becomes exactly (1, 1, 1), unless it is not adapted.
struct ColourWeights {
    std::array<Sampled, 3> weight;
    std::string space, illuminant;
    ObserverId observer;
    Mat3 to_xyz_d65;  ///< of the space: from what `apply` returns to XYZ, e.g. for ΔE00

    [[nodiscard]] Vec3 apply(const Sampled& reflectance) const noexcept;
    /// The colour of a perfect white.
    [[nodiscard]] Vec3 white() const noexcept;
};

[[nodiscard]] ColourWeights reflectance_weights(const Illuminant& illuminant, ObserverId observer,
                                                const ColourSpace& space,
                                                Adaptation how = Adaptation::bradford);

}  // namespace nacre::spectral
