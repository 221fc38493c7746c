// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_table.h"

// Films on rough surfaces. A rough table holds NACRE_SLICES tables side by side, of roughness 0.1,
// 0.2 … 1, each over the cosine; between two of them, and between the smooth table and the first,
// colours are mixed.
#define NACRE_SLICES 10

float nacre_level(float roughness)
{
    return clamp(roughness, 0.0, 1.0) * NACRE_SLICES;
}

// Slice 1 … NACRE_SLICES of a rough table whose slices are `width` texels wide.
color nacre_slice(string file, float slice, float x, float y, float width, float height,
                  int origin_top)
{
    float column = (slice - 1.0) * width + clamp(x, 0.0, 1.0) * (width - 1.0);
    float columns = NACRE_SLICES * width;
    return nacre_table(file, column / (columns - 1.0), y, columns, height, origin_top);
}

// From a rough table at `level`, above the colour of a smooth surface.
color nacre_rough_table(string file, color smooth, float level, float x, float y, float width,
                        float height, int origin_top)
{
    float low = floor(level);
    color below = low < 1.0 ? smooth : nacre_slice(file, low, x, y, width, height, origin_top);
    if (level == low) return below;
    return mix(below, nacre_slice(file, low + 1.0, x, y, width, height, origin_top), level - low);
}

// One term of a reflectance that is a sum of powers over the facet's cosine, c (1 - cos)^e, of any
// sign: a Schlick reflectance of f0 = 0, f90 = c.
closure color nacre_power_lobe(normal n, color coefficient, float exponent, float alpha)
{
    return generalized_schlick_bsdf(n, vector(0.0), color(1.0), color(0.0), alpha, alpha,
                                    color(0.0), coefficient, exponent, "ggx");
}
