// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "nacre/bands/bands.h"

/// @file
/// How far bands are from every tenth of a nanometre, and how many a scene needs.

namespace nacre::bands {

/// ΔE00 between the sum over bands and that over 0.1 nm, relative to the light's own white.
struct BandError {
    double mean, max;
};

/// @param reflectances  of surfaces, one or more
/// @pre each of kFineWavelengths values
[[nodiscard]] BandError band_error(const Bands& bands, const Light& light,
                                   std::span<const Fine> reflectances);

/// Nine films around one of this optical thickness (index times thickness, in nm), the thinnest 0.9
/// and the thickest 1.1 times as thick: ½ − ½ cos(4π nd/λ), of the largest contrast that fringes
/// can have.
[[nodiscard]] std::vector<Fine> fringes(double optical_thickness_nm);

/// Something that sends wavelengths in different directions, as an image of it shows them.
struct Spread {
    Fine position_px;  ///< where light of each wavelength comes to lie, in pixels
};

/// The widest step between neighbouring wavelengths that does not show, in pixels.
inline constexpr double kWidestStepPx = 1.3;

/// Read by film_weights() of its optical thickness.
struct Film {
    double optical_thickness_nm;
    std::vector<Fine> reflectances;  ///< at some thicknesses; without any those of fringes()
};

struct Needs {
    std::vector<Light> lights;
    std::vector<Fine> reflectances;
    std::vector<Film> films;
    std::vector<Spread> spreads;
    double mean_error = 0.1, max_error = 0.3;  ///< of `reflectances`; of films the mean alone
};

struct Choice {
    int passes;
    Bands bands;       ///< three times as many
    BandError error;   ///< of reflectances under the light that is worst off
    double films;      ///< mean ΔE00 of a film, the worst; 0 without films
    double step_px;    ///< the widest step of a spread; 0 without spreads
    std::string held;  ///< what is nearest to its limit: "lights", "lines", "films", "spreads"
    bool met;          ///< false where even the most passes are not enough
};

/// Passes of three bands that a choice is made from.
inline constexpr int kPasses[] = {8, 10, 14, 16, 20, 26, 32, 40, 50, 64, 80, 100};

/// The fewest passes that are within the errors asked for.
/// @throws InputError without lights, or when they have more lines than the most bands can hold
[[nodiscard]] Choice choose_bands(const Needs& needs, spectral::ObserverId observer);

}  // namespace nacre::bands
