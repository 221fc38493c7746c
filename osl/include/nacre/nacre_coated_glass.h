// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_fresnel.h"
#include "nacre/nacre_surface.h"

// A film on solid, clear glass. Reflectance and transmittance of a film are the same from both
// sides as long as nothing absorbs, at angles that belong together by refraction: smooth tables
// over the cosine in the ambient serve the inside too, where total reflection is the cosine 0.

float nacre_ambient_cosine(float cosine, float index)
{
    if (!backfacing()) return cosine;
    return sqrt(max(0.0, 1.0 - index * index * (1.0 - cosine * cosine)));
}

// Where the slices of a rough table are read: from outside the cosine. From inside the cosine c in
// the ambient has the upper half, (1 + c) / 2, and beyond the border of total reflection the decay
// d over its most the lower one, (1 - d) / 2.
float nacre_glass_column(float cosine, float index)
{
    if (!backfacing()) return cosine;
    float along = 1.0 - index * index * (1.0 - cosine * cosine);
    float decay = -along / max(1e-6, index * index - 1.0);
    return 0.5 + 0.5 * (sqrt(max(0.0, along)) - sqrt(clamp(decay, 0.0, 1.0)));
}

// The renderer's own dielectric interface, whose Fresnel reflectance F gives way to the film: R / F
// and T / (1 - F) as its tints. So a signed colour survives, rough glass refracts at each
// microfacet, and one closure chooses between both ways. On a rough surface F and 1 - F are means
// over the facets, as R and T are: `lobe_R` and `lobe_T`. Facets in total reflection
// send more than the mean; none may send more than it gets, so that what the film reflects beyond F
// is a lobe of its own, of facets that are all alike.
closure color nacre_coated_glass(normal n, float roughness, float index, color R, color T,
                                 color lobe_R, color lobe_T)
{
    float relative = backfacing() ? 1.0 / index : index;
    float cosine = clamp(fabs(dot(n, I)), 0.0, 1.0);
    color F = lobe_R, passed = lobe_T;
    if (roughness <= 0.0) {
        F = color(nacre_reflectance(1.0, nacre_real(relative), cosine));
        passed = color(1.0) - F;
    }
    color reflected = R / max(F, color(1e-6));
    color beyond = 0.0;
    if (roughness > 0.0) {
        reflected = min(reflected, color(1.0));
        beyond = R - F * reflected;
    }
    float alpha = roughness * roughness;
    closure color glass = dielectric_bsdf(n, vector(0.0), reflected, T / max(passed, color(1e-6)),
                                          alpha, alpha, relative, "ggx");
    if (max(beyond[0], max(beyond[1], beyond[2])) > 0.0)
        glass = nacre_reflection(n, beyond, roughness) + glass;
    return glass;
}
