// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_fresnel.h"
#include "nacre/nacre_wavelength.h"

// Smooth or rough dispersive glass with one wavelength per path.
//
// The weight of the wavelength multiplies what enters the first transmitting object of a path, and
// nothing else: transmission_depth counts every refraction so far, so leaving the glass, inner
// reflections and further objects find it above 0. What the first surface reflects carries no
// weight and so no colour noise, but its reflectance F(n(wavelength)) then averages without the
// weight, while 1 - F averages with it. F(index_rgb) / F(n) as its tint puts the weighted mean
// there: index_rgb is the weighted mean of n, and F is linear in n to about 1e-5 over the spread of
// a glass.
closure color nacre_glass_lobe(normal n, float roughness, float index, color index_rgb,
                               color weight)
{
    int transmissions = 0;
    getattribute("path:transmission_depth", transmissions);
    color reflected = 1.0;
    color transmitted = 1.0;
    if (transmissions == 0) {
        transmitted = weight;
        if (!backfacing()) {
            float cosine = clamp(fabs(dot(n, I)), 0.0, 1.0);
            for (int c = 0; c < 3; c++)
                reflected[c] = nacre_reflectance(1.0, nacre_real(index_rgb[c]), cosine);
            reflected /= max(1e-6, nacre_reflectance(1.0, nacre_real(index), cosine));
        }
    }
    float alpha = roughness * roughness;
    float relative = backfacing() ? 1.0 / index : index;
    return dielectric_bsdf(n, vector(0.0), reflected, transmitted, alpha, alpha, relative, "ggx");
}
