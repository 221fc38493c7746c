// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_fresnel.h"

// A film on solid, clear glass. Reflectance and transmittance of a film are the same from both
// sides as long as nothing absorbs, at angles that belong together by refraction: tables over the
// cosine in the ambient serve the inside too, where total reflection is the cosine 0.

float nacre_ambient_cosine(float cosine, float index)
{
    if (!backfacing()) return cosine;
    return sqrt(max(0.0, 1.0 - index * index * (1.0 - cosine * cosine)));
}

// The renderer's own dielectric interface, whose Fresnel reflectance F gives way to the film: R / F
// and T / (1 - F) as its tints. So a signed colour survives, rough glass refracts at each
// microfacet, and one closure chooses between both ways. On a rough surface F is a mean over the
// facets, as R and T are: R_bare.
closure color nacre_coated_glass(normal n, float roughness, float index, color R, color T,
                                 color R_bare)
{
    float relative = backfacing() ? 1.0 / index : index;
    float cosine = clamp(fabs(dot(n, I)), 0.0, 1.0);
    color F =
        roughness > 0.0 ? R_bare : color(nacre_reflectance(1.0, nacre_real(relative), cosine));
    float alpha = roughness * roughness;
    return dielectric_bsdf(n, vector(0.0), R / max(F, color(1e-6)),
                           T / max(color(1.0) - F, color(1e-6)), alpha, alpha, relative, "ggx");
}
