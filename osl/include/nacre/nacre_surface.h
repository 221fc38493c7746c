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
