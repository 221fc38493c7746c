// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_table.h"

// Films on rough surfaces. A rough table holds NACRE_SLICES tables side by side, of roughness 0.1,
// 0.2 … 1, each over the cosine; between two of them, and between the smooth table and the first,
// colours are mixed by nacre_slice_share().
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

// Share of the slice above the level `low` in what is read at `level`: linear in alpha squared, the
// fourth power of the roughness, as means over facets and a lobe's albedo are.
float nacre_slice_share(float level, float low)
{
    float below = pow(low, 4.0), above = pow(low + 1.0, 4.0);
    return (pow(level, 4.0) - below) / (above - below);
}

// From a rough table at `level`, above the colour of a smooth surface.
color nacre_rough_table(string file, color smooth, float level, float x, float y, float width,
                        float height, int origin_top)
{
    float low = floor(level);
    color below = low < 1.0 ? smooth : nacre_slice(file, low, x, y, width, height, origin_top);
    if (level == low) return below;
    color above = nacre_slice(file, low + 1.0, x, y, width, height, origin_top);
    return mix(below, above, nacre_slice_share(level, low));
}

// Facets of a rough surface: GGX alpha along the tangent and across. Two surfaces without a
// direction stand in for a brushed one, by their roughness: `seen` at the cosine of the view
// `seen_cosine` has facets at the same angles to the viewer, `overall` as many further bounces.
struct nacre_facets {
    vector tangent;
    float alpha_x, alpha_y;
    float seen, seen_cosine;
    float overall;
};

nacre_facets nacre_isotropic_facets(float cosine, float roughness)
{
    float held = clamp(roughness, 0.0, 1.0);
    nacre_facets facets = {vector(0.0), held * held, held * held, held, cosine, held};
    return facets;
}

// Anisotropy and rotation are those of the Glossy node. From the side only the slopes along the
// line of sight count, from above all alike: alpha^2 seen is their mean where c^4 of the view is 1,
// and that along the line of sight where it is 0. The fourth power fits light that walks among
// facets. Slopes p, q turn a facet by 1 / sqrt(1 + p^2 + q^2), whatever their direction: what the
// stand-in lacks of that is put into the cosine of its view.
nacre_facets nacre_brushed_facets(normal n, vector tangent, float cosine, float roughness,
                                  float anisotropy, float rotation)
{
    float held = clamp(roughness, 0.0, 1.0);
    float along = 1.0 - clamp(anisotropy, 0.0, 0.99), across = 1.0 + clamp(anisotropy, -0.99, 0.0);
    float alpha_x = min(1.0, held * held * along / across);
    float alpha_y = min(1.0, held * held * across / along);
    vector turned = rotate(tangent, rotation * M_2PI, point(0.0), point(n));
    vector x = normalize(turned - n * dot(n, turned));
    float t = dot(x, I), cc = cosine * cosine;
    float squared_x = alpha_x * alpha_x, squared_y = alpha_y * alpha_y;
    float mean = 0.5 * (squared_x + squared_y);
    float in_plane = squared_y * (1.0 - cc) + (squared_x - squared_y) * t * t;
    float squared = max(0.0, mean * cc * cc + in_plane * (1.0 + cc));
    float tilt = (2.0 + squared) / (2.0 + mean);
    nacre_facets facets = {turned,
                           alpha_x,
                           alpha_y,
                           min(1.0, pow(squared, 0.25)),
                           min(1.0, cosine * tilt),
                           min(1.0, pow(mean, 0.25))};
    return facets;
}

// A lobe of one colour, which may be outside the gamut.
closure color nacre_tinted_lobe(normal n, color tint, nacre_facets facets)
{
    return generalized_schlick_bsdf(n, facets.tangent, tint, color(0.0), facets.alpha_x,
                                    facets.alpha_y, color(1.0), color(1.0), 1.0, "ggx");
}

// One term of a reflectance that is a sum of powers over the facet's cosine, c (1 - cos)^e, of any
// sign: a Schlick reflectance of f0 = 0, f90 = c.
closure color nacre_power_lobe(normal n, color coefficient, float exponent, nacre_facets facets)
{
    return generalized_schlick_bsdf(n, facets.tangent, color(1.0), color(0.0), facets.alpha_x,
                                    facets.alpha_y, color(0.0), coefficient, exponent, "ggx");
}
