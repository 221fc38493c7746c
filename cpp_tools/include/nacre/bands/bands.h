// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/bands/fine_grid.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/matrix.h"
#include "nacre/spectral/observer.h"
#include "nacre/spectral/wavelengths.h"

/// @file
/// A spectrum as a few numbers: bands, each with one wavelength at which surfaces are known and one
/// colour that light in it has. A renderer of three channels takes three bands a pass.

namespace nacre::bands {

/// A light as bands see it: what is spread over wavelengths, and what is not.
struct Light {
    std::string name;  ///< for messages
    Fine power;        ///< per nm, ≥ 0; empty where there are lines alone
    std::vector<spectral::SpectralLine> lines;
};

/// By what a user calls it, as spectral::named_illuminant() has it; `line:…` gives lines.
/// @throws InputError as spectral::named_illuminant()
[[nodiscard]] Light named_light(std::string_view text);

struct Band {
    double first_nm, last_nm;  ///< a band ends where the next one begins
    double wavelength_nm;  ///< what surfaces are looked up at: its middle to the eye, or its line
    spectral::Vec3 xyz;  ///< of an emission of 1 per nm in it, ∫ CMF dλ / ∫ ȳ dλ; of a line as
                         ///< wide as the band: CMF at the line
    bool is_line;  ///< made for a line, or for some too near each other to be told apart
};

struct Bands {
    spectral::ObserverId observer;
    std::vector<Band> bands;  ///< ascending; they cover 360 … 830 nm

    [[nodiscard]] std::size_t size() const noexcept { return bands.size(); }
    /// The colour of a radiance per nm in each band. @pre values.size() == size()
    [[nodiscard]] spectral::Vec3 xyz(std::span<const double> values) const noexcept;
};

/// Around a line, what is one band: finer than any colour can tell.
inline constexpr double kLineWidthNm = 1.0;
inline constexpr int kMostBands = 300;

/// How many it takes to hold the lines of lights: a line and what is between two of them one each.
[[nodiscard]] int fewest_bands(std::span<const Light> lights);

/// `count` bands for all of `lights` together. Between lines they hold equal masses of
/// √(x̄ + ȳ + z̄), to one half, and of √((x̄ + ȳ + z̄) S) of each light S to the other, so that bands
/// are narrow where a lamp has peaks; with no lights of the first alone.
/// @throws InputError unless fewest_bands(lights) ≤ count ≤ kMostBands
[[nodiscard]] Bands make_bands(int count, std::span<const Light> lights,
                               spectral::ObserverId observer);

/// The power per nm of a light in each band, ≥ 0: not its mean over the band, which knows nothing
/// of where in the band the lamp shines and where the eye looks, but numbers near it such that the
/// sum over bands is right for surfaces whose reflectance is a cosine of the wavelength, up to half
/// as many half periods over 390 … 720 nm as there are bands. Of perfect white it is right to 1e-5.
///
/// That is a least-squares fit, Σ_j (Σ_k W_k S_k φ_j(λ_k) − ∫ W S φ_j dλ)² + ρ² Σ_k |W_k|² (S_k −
/// S̄_k)², white weighed a thousandfold, S_k ≥ 0. Lines that have a band are not part of it.
[[nodiscard]] std::vector<double> light_in_bands(const Bands& bands, const Light& light);

/// What a film of this optical thickness (index times thickness) is in a band, as weights of the
/// nanometres, 1 together: its reflectance at Band::wavelength_nm, by a cubic through four of them,
/// or where it has more fringes than bands can tell, its mean over the band to the eye. Under D65
/// 24 bands show films to 1.5 µm so within ΔE00 0.1 on average, those of 2.5 µm and more within
/// 0.6, where reading at one wavelength is off by 3 at 6 µm.
[[nodiscard]] spectral::Sampled film_weights(const Bands& bands, std::size_t band,
                                             double optical_thickness_nm);

}  // namespace nacre::bands
