// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_table.h"

// Films on rough surfaces. A rough table holds NACRE_SLICES tables side by side, of roughness 0.1,
// 0.2 … 1, each over the cosine; between two of them, and between the smooth table and the first,
// colours are mixed by nacre_slice_share(). Of glass there are as many slices again, seen from
// inside.
#define NACRE_SLICES 10

float nacre_level(float roughness)
{
    return clamp(roughness, 0.0, 1.0) * NACRE_SLICES;
}

// Slice 1 … NACRE_SLICES of the side that is seen, of a rough table of `sides` whose slices are
// `width` texels wide.
color nacre_slice(string file, float slice, int sides, float x, float y, float width, float height,
                  int origin_top)
{
    float before = slice - 1.0 + (sides > 1 && backfacing() ? NACRE_SLICES : 0);
    float column = before * width + clamp(x, 0.0, 1.0) * (width - 1.0);
    float columns = sides * NACRE_SLICES * width;
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
color nacre_rough_table(string file, color smooth, float level, int sides, float x, float y,
                        float width, float height, int origin_top)
{
    float low = floor(level);
    color below =
        low < 1.0 ? smooth : nacre_slice(file, low, sides, x, y, width, height, origin_top);
    if (level == low) return below;
    color above = nacre_slice(file, low + 1.0, sides, x, y, width, height, origin_top);
    return mix(below, above, nacre_slice_share(level, low));
}

// Facets of a rough surface: GGX alpha along the tangent and across. Surfaces without a direction
// stand in for a brushed one, by their roughness, at the cosine of the view `seen_cosine`: `seen`
// has facets at the same angles to the viewer, `further_scale` times what `further` sends back
// after two and more bounces is as much as here.
struct nacre_facets {
    vector tangent;
    float alpha_x, alpha_y;
    float seen, seen_cosine;
    float further, further_scale;
};

nacre_facets nacre_isotropic_facets(float cosine, float roughness)
{
    float held = clamp(roughness, 0.0, 1.0);
    nacre_facets facets = {vector(0.0), held * held, held * held, held, cosine, held, 1.0};
    return facets;
}

// ln of what white facets lose to others in one bounce, over what they do not: rows of `lost` are
// coefficients over ln(alpha), columns over ln(cosine).
float nacre_lost_light(float lost[12], float alpha_squared, float cosine_squared)
{
    float u = 0.5 * log(alpha_squared), v = 0.5 * log(cosine_squared);
    float sum = 0.0;
    for (int i = 9; i >= 0; i -= 3) sum = sum * u + lost[i] + v * (lost[i + 1] + v * lost[i + 2]);
    return sum;
}

// Anisotropy and rotation are those of the Glossy node. From the side only the slopes along the
// line of sight count, from above all alike: alpha^2 seen is their mean where c^4 of the view is 1,
// and that along the line of sight where it is 0. The fourth power fits light that walks among
// facets. Slopes p, q turn a facet by 1 / sqrt(1 + p^2 + q^2), whatever their direction: what the
// stand-in lacks of that is put into the cosine of its view.
//
// Light that goes on to other facets keeps its angle to the grooves: along them all bounces graze,
// and have the colours that they have on the surface that is seen. How much goes on is another
// matter: as much as on a surface of the mean alpha^2 seen where tan is that of the view times
// alpha along the line of sight over its mean, for Smith's masking knows that product alone.
// Grooves lose a little less: 0.12 meets the white furnace best. Surfaces smoother than a fifth of
// the mean alpha send on too little to be scaled. `least_alpha` and `least_cosine` are where `lost`
// begins.
nacre_facets nacre_brushed_facets(normal n, vector tangent, float cosine, float roughness,
                                  float anisotropy, float rotation, float lost[12],
                                  float least_alpha, float least_cosine)
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
    float seen_cosine = min(1.0, cosine * tilt);

    float further = max(squared, 0.04 * mean);
    float half_gap = 0.5 * (squared_x - squared_y);
    float lossy = mean - 0.12 * half_gap * half_gap / mean;
    float stretched = cc * mean / (mean * cc + in_plane);
    float least = least_alpha * least_alpha, grazing = least_cosine * least_cosine;
    float goes_on =
        nacre_lost_light(lost, max(lossy, least), max(stretched, grazing)) -
        nacre_lost_light(lost, max(further, least), max(seen_cosine * seen_cosine, grazing));
    nacre_facets facets = {turned,      alpha_x,
                           alpha_y,     min(1.0, pow(squared, 0.25)),
                           seen_cosine, min(1.0, pow(further, 0.25)),
                           exp(goes_on)};
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
