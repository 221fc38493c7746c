// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Lobes whose colour may be outside the working gamut. Cycles cuts a negative closure weight to 0,
// but takes a signed tint as it is: so the weight stays 1 and the colour enters as the tint of a
// Schlick term that reflects everything (f0 = f90 = 1).
closure color nacre_reflection(normal n, color tint, float roughness)
{
    float alpha = roughness * roughness;
    return generalized_schlick_bsdf(n, vector(0.0), tint, color(0.0), alpha, alpha, color(1.0),
                                    color(1.0), 1.0, "ggx");
}

// What a matt base under a film and a clear substrate sends towards the film, per unit of light
// that a direction lets through: the light that enters is spread over the hemisphere, part of it
// leaves (T_inner), part falls back on the base (R_inner), again and again. A geometric series,
// whose sum is 1 for a white base under films that do not absorb: T_inner = 1 - R_inner.
color nacre_base_colour(color base, color R_inner, color T_inner)
{
    color albedo = clamp(base, color(0.0), color(1.0));
    return albedo * T_inner / max(color(1e-4), color(1.0) - albedo * R_inner);
}
