// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/spectral/colour.h"

/// @file
/// One film as renderers evaluate it that have no spectrum: Fresnel terms in three channels, and
/// the integral over wavelengths in closed form, because the Fourier transform of a Gaussian is one
/// (Belcour and Barla 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying
/// Iridescence", section 4). Here to find parameters for them, and to say how far off they are; the
/// multilayer of multilayer.h is the truth.
///
/// Results are linear Rec.709; ambient is air.

namespace nacre::optics {

/// Surface of glTF with the extension KHR_materials_iridescence.
struct KhrIridescence {
    double film_ior;         ///< iridescenceIor, ≥ 1
    double film_nm;          ///< thickness, ≥ 0
    spectral::Vec3 base_f0;  ///< of the base in air: colour of a metal; of a dielectric by its ior
    double factor = 1.0;     ///< iridescenceFactor, 0…1
};

/// Fresnel term F as the ratified extension has it in its implementation notes ("Iridescence
/// Fresnel"): Schlick at both faces, no polarisation, two further orders. Mixed with Schlick's by
/// `factor`. Not below 0, may exceed 1.
/// @param cos_theta  between view and facet normal, in [0, 1]
[[nodiscard]] spectral::Vec3 khr_iridescence(const KhrIridescence& surface, double cos_theta);

/// A film in the inputs `thinfilm_ior` and `thinfilm_thickness` of MaterialX' conductor_bsdf, or of
/// its dielectric_bsdf where `base_k` is 0.
struct MaterialXFilm {
    double film_ior;  ///< ≥ 1
    double film_nm;   ///< ≥ 0
    spectral::Vec3 base_n, base_k;
};

/// What the shaders make of it that MaterialX 1.39 generates (genglsl, mx_fresnel_airy): Fresnel
/// terms and phases of each polarisation, two further orders, sensitivities of XYZ each with the
/// optical constants of one channel; 0…1.
[[nodiscard]] spectral::Vec3 materialx_film(const MaterialXFilm& film, double cos_theta);

}  // namespace nacre::optics
