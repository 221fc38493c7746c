// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_fresnel.h"
#include "nacre/nacre_wavelength.h"

// Smith's Lambda of GGX facets.
float nacre_smith_lambda(float cosine, float alpha)
{
    float c = max(1e-4, cosine);
    return 0.5 * (sqrt(1.0 + alpha * alpha * (1.0 - c * c) / (c * c)) - 1.0);
}

// Share of the light that leaves rough clear glass after one bounce, reflected or refracted (Walter
// et al. 2007): the mean over visible normals of what shadowing, correlated in height, leaves.
// Evenly over half the azimuths, by Gauss and Legendre over the root of the other number that draws
// a normal; within 0.5 % for light that enters.
float nacre_kept_light(float cosine, float alpha, float relative)
{
    float at[6] = {0.033765243, 0.169395307, 0.380690407, 0.619309593, 0.830604693, 0.966234757};
    float share[6] = {0.085662246, 0.180380787, 0.233956967, 0.233956967, 0.180380787, 0.085662246};
    float mu = clamp(cosine, 1e-3, 1.0);
    vector view = vector(sqrt(1.0 - mu * mu), 0.0, mu);
    vector stretched = normalize(vector(alpha * view[0], 0.0, mu));
    float seen = 1.0 + nacre_smith_lambda(mu, alpha);
    float kept = 0.0;
    for (int i = 0; i < 8; i++) {
        float azimuth = M_PI * (i + 0.5) / 8.0;
        for (int j = 0; j < 6; j++) {
            float z = at[j] * at[j] * (1.0 + stretched[2]) - stretched[2];
            float across = sqrt(max(0.0, 1.0 - z * z));
            vector facet = vector(cos(azimuth) * across, sin(azimuth) * across, z) + stretched;
            facet = normalize(vector(alpha * facet[0], alpha * facet[1], max(facet[2], 1e-6)));
            float c = clamp(dot(view, facet), 0.0, 1.0);
            float F = nacre_reflectance(1.0, nacre_real(relative), c);
            float up = 2.0 * c * facet[2] - mu;
            float refracted = sqrt(max(0.0, 1.0 - (1.0 - c * c) / (relative * relative)));
            float down = mu / relative - (c / relative - refracted) * facet[2];
            float leaves = 0.0;
            if (up > 0.0) leaves += F * seen / (seen + nacre_smith_lambda(up, alpha));
            if (down > 0.0) leaves += (1.0 - F) * seen / (seen + nacre_smith_lambda(down, alpha));
            kept += 2.0 * at[j] * share[j] * leaves / 8.0;
        }
    }
    return kept;
}

// Smooth or rough dispersive glass with one wavelength per path.
//
// The weight of the wavelength multiplies what enters the first transmitting object of a path, and
// nothing else: transmission_depth counts every refraction so far, so leaving the glass, inner
// reflections and further objects find it above 0. What the first surface reflects carries no
// weight and so no colour noise, but its reflectance F(n(wavelength)) then averages without the
// weight, while 1 - F averages with it. F(index_rgb) / F(n) as its tint puts the weighted mean
// there: index_rgb is the weighted mean of n, and F is linear in n to about 1e-5 over the spread of
// a glass.
//
// One bounce among rough facets loses light to others; Cycles makes up for it (multi_ggx) where
// nothing is tinted. From a tint it takes the colour of the further bounces too, which a weight,
// signed and above 1, is not: there the loss is ours to make up for.
closure color nacre_glass_lobe(normal n, float roughness, float index, color index_rgb,
                               color weight)
{
    int transmissions = 0;
    getattribute("path:transmission_depth", transmissions);
    float alpha = roughness * roughness;
    float relative = backfacing() ? 1.0 / index : index;
    color reflected = 1.0;
    color transmitted = 1.0;
    string facets = roughness > 0.0 ? "multi_ggx" : "ggx";
    if (transmissions == 0) {
        float cosine = clamp(fabs(dot(n, I)), 0.0, 1.0);
        transmitted = weight;
        if (!backfacing()) {
            for (int c = 0; c < 3; c++)
                reflected[c] = nacre_reflectance(1.0, nacre_real(index_rgb[c]), cosine);
            reflected /= max(1e-6, nacre_reflectance(1.0, nacre_real(index), cosine));
        }
        if (roughness > 0.0 && weight != color(1.0)) {
            float kept = nacre_kept_light(cosine, min(1.0, alpha), relative);
            reflected /= kept;
            transmitted /= kept;
            facets = "ggx";
        }
    }
    return dielectric_bsdf(n, vector(0.0), reflected, transmitted, alpha, alpha, relative, facets);
}
