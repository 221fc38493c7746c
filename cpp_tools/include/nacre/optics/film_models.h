// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "nacre/optics/film_stack.h"

/// @file
/// Closed forms for one film, as they are found in the literature on rendering, each with the
/// domain that it holds in. The multilayer of multilayer.h is the reference: where a form is exact
/// it agrees to rounding, where it is not its error is stated. Time factor exp(−iωt), as
/// everywhere.
///
/// Each function throws InputError where its domain ends; fields are named as in `eval film`.

namespace nacre::optics {

/// One film between half-spaces; ambient and film are clear.
struct SingleFilm {
    double n_ambient, n_film;
    Complex n_base;
    double thickness_nm;
};

/// Unpolarised light is the mean over both polarisations of what follows.
struct Incidence {
    double cos_ambient;  ///< in (0, 1]
    double wavelength_nm;
    Polarisation polarisation;
};

/// Phase of one round trip in the film, δ = 4π n d cosθ₁/λ.
/// @throws InputError where the film reflects totally
[[nodiscard]] double round_trip_phase(const SingleFilm& film, double cos_ambient,
                                      double wavelength_nm);

/// Stylised bands: the fraction of a wavelength in 2 n d cosθ_light cosθ_view, angles inside the
/// film; no physics, in [0, 1). At equal angles its bands are 1/cosθ₁ times as far
/// apart in d as those of interference, and a factor of the Fresnel coefficients is missing.
[[nodiscard]] double path_difference_bands(const SingleFilm& film, double cos_light,
                                           double cos_view, double wavelength_nm);

/// Their mean in the mirror direction, cosθ_light = cosθ_view, over the wave numbers of the cell of
/// wavelengths `cell_nm` wide around this one; 0 means a point. Exact at the indices of its centre.
[[nodiscard]] double path_difference_mean(const SingleFilm& film, double cos_ambient,
                                          double wavelength_nm, double cell_nm);

/// |(r01 + r12 e^{iδ})/(1 + r01 r12 e^{iδ})|² (Durikovic and Kimura 2006). Exact.
/// Domain: clear base, no total reflection.
[[nodiscard]] double airy_reflectance(const SingleFilm& film, const Incidence& light);

/// Reflection at the top, one and two round trips, no more:
/// |r01 + t01 t10 r12 e^{iδ} (1 + r10 r12 e^{iδ})|². Domain: clear base, no total reflection.
/// Energy is not conserved: beyond |r10 r12|² the series is cut, see `series_error_bound`.
[[nodiscard]] double series_reflectance(const SingleFilm& film, const Incidence& light);

/// What the same series passes on: light that leaves below after none, one and two round trips,
/// |t01 t12 e^{iδ/2} (1 + ρ + ρ²)|² times the ratio of n cosθ, ρ = r10 r12 e^{iδ}. The same domain.
[[nodiscard]] double series_transmittance(const SingleFilm& film, const Incidence& light);

/// Bound of |series_reflectance − airy_reflectance|: the remainder of the geometric series,
/// ε = |t01 t10 r12| ρ²/(1 − ρ) with ρ = |r10 r12|, moves |r|² by at most ε (2|r| + ε).
[[nodiscard]] double series_error_bound(const SingleFilm& film, const Incidence& light);

/// Film on an absorbing base (Sun and Wang 2008, with the sign of this time factor):
/// (r01² + |r12|² + 2 r01 C)/(1 + r01² |r12|² + 2 r01 C), C = Re r12 cosδ − Im r12 sinδ. Exact.
/// Domain: no total reflection in the film; the base may be clear or absorb.
[[nodiscard]] double opaque_base_reflectance(const SingleFilm& film, const Incidence& light);

/// Film with the same medium on both sides, 2r²(1 − cosδ)/(1 + r⁴ − 2r² cosδ). Exact.
/// Domain: n_base equals n_ambient, no total reflection.
[[nodiscard]] double free_film_reflectance(const SingleFilm& film, const Incidence& light);

/// Airy's function 1/(1 + F sin²(δ/2)), F = 4R/(1 − R)², of a lossless etalon whose mirrors have
/// the reflectance R and shift no phase. With R = r01² of a free film it is that film's
/// transmittance. Domain: 0 ≤ mirror_reflectance < 1.
[[nodiscard]] double etalon_transmittance(double mirror_reflectance, double phase_rad);

/// 1 − etalon_transmittance, at the phase of the film. Mirrors of a given reflectance, or the faces
/// of the film, by the Fresnel coefficients of its upper one. Exact for a free film of its own
/// faces. Domain: no total reflection in the film.
[[nodiscard]] double etalon_reflectance(const SingleFilm& film, const Incidence& light,
                                        std::optional<double> mirror_reflectance);

/// Any number of absorbing layers from the substrate up, with E = e^{iΔ}, Δ = 2π N d cosθ/λ:
/// γ ← (r + γE²)/(1 + rγE²), τ ← tτE/(1 + rγE²) (Hirayama et al. 2001). Exact, total reflection
/// included. The form that was published; `stack_amplitudes` works in variables that stay defined
/// where this one is 0/0.
/// Domain: all layers coherent and without a spread, no layer at its critical angle, where its
/// t has no value; a stack without problems (`validate`).
[[nodiscard]] Amplitudes recursion_amplitudes(const FilmStack& stack, const Incidence& light);

/// R and T of these amplitudes.
[[nodiscard]] PowerRatios recursion_power(const FilmStack& stack, const Incidence& light);

/// Forms that give a reflectance from a film and its light alone.
enum class FilmModel { path_difference, airy, series, opaque_base, free_film, etalon, recursion };

/// "path_difference", "airy", …, in the order of the enumeration.
[[nodiscard]] std::span<const std::string_view> film_model_names();
[[nodiscard]] std::string_view film_model_name(FilmModel model);

/// @throws InputError for a name that is not among them.
[[nodiscard]] FilmModel film_model_from_name(std::string_view name);

/// By the form of that name; an etalon of the film's own faces, and path_difference with the light
/// in the mirror direction.
[[nodiscard]] double film_reflectance(FilmModel model, const SingleFilm& film,
                                      const Incidence& light);

/// cosθ₂ = u + iv below an interface, and the reflection coefficients, in real arithmetic alone
/// (Born and Wolf 1999, section 14.4.1). Exact.
struct UvForm {
    double u, v;
    Complex r_s, r_p;
};

/// Domain: n_ambient > 0, Re n_base > 0, Im n_base ≥ 0, cos_ambient in (0, 1].
[[nodiscard]] UvForm uv_interface(double n_ambient, Complex n_base, double cos_ambient);

/// Fraunhofer intensity behind slits, 1 straight ahead: sinc²(πb sinα/λ), and for two slits of the
/// distance `spacing_nm` between centres times cos²(πd sinα/λ); 0 means one slit.
/// Domain: width > 0; spacing 0 or ≥ width.
[[nodiscard]] double slit_intensity(double width_nm, double spacing_nm, double sin_angle,
                                    double wavelength_nm);

}  // namespace nacre::optics
