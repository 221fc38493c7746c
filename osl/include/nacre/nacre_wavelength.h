// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One wavelength per path, for a renderer that carries only RGB.

struct nacre_wavelength {
    float nm;
    color weight;  // signed; the mean over all wavelengths is exactly (1, 1, 1)
    int cell;
};

// A uniform number in [0, 1) that belongs to the camera path. Cycles with motion blur on, a flat
// shutter curve and a shutter of 0 gives every path a stratified time of (0.5 + 254 u) / 256. With
// motion blur off it is 0.5 exactly, and a hash of the position stands in: right in the mean, but
// with more noise, and it changes along the path.
float nacre_path_random()
{
    float u = time == 0.5 ? (float)hashnoise(P) : (256.0 * time - 0.5) / 254.0;
    return clamp(u, 0.0, 0.999999);
}

// A uniform number of the path at depth 1 and more, independent of u and of those at other depths.
// A prime number of places in u, permuted otherwise at each depth by the powers of 219, shifts
// where in its place u lies. Unlike a hash of the position, which would do as well, it comes out
// the same on processors that round otherwise.
float nacre_later_random(float u, int depth)
{
    int places = 4093;
    int place = min((int)(u * places), places - 1);
    int shift = place;
    for (int i = 0; i < depth; i++) shift = (219 * shift) % places;
    float v = u * places - place + (float)shift / places;
    return clamp(v - floor(v), 0.0, 0.999999);
}

// A second uniform number of the path, for surfaces that need no wavelength in common with others.
//
// What a glass bends stays one wavelength's, and its weight goes with the path from there on. A
// surface that weights by the same wavelength again would square the weight; with one that is
// independent, the product of the means remains: white stays white, and colours multiply as they
// do in any RGB renderer. Seen at once, a permutation of the cells keeps the path's stratification;
// the weights of cells i and 39 i + 58 correlate by 0.7 % at most in Rec.709, Rec.2020 and ACEScg.
// Behind glass or after a reflection, which may have weighted already, the number is independent of
// all before, but less well stratified: weights correlate by 0.05 % at most, those of three
// surfaces by 0.3 %.
float nacre_second_random(float u, int cells)
{
    int transmissions = 0;
    int reflections = 0;
    getattribute("path:transmission_depth", transmissions);
    getattribute("path:glossy_depth", reflections);
    int depth = transmissions + reflections;
    if (depth > 0) return nacre_later_random(u, depth);
    int cell = min((int)(u * cells), cells - 1);
    float v = ((39 * cell + 58) % cells + u * cells - cell) / cells;
    return clamp(v - floor(v), 0.0, 0.999999);
}

// What a metal of a colour leaves of light of one cell of wavelengths. A signed weight times a
// colour would be the same in the mean, but has a negative sum where the colour is saturated, and
// Cycles drops such a lobe. `basis` is one triple a cell: dual to colours, so that this number is
// the same in every colour space.
float nacre_at_wavelength(color tint, color basis)
{
    return max(0.0, tint[0] * basis[0] + tint[1] * basis[1] + tint[2] * basis[2]);
}

// Inverse CDF over equal cells of u: cell i holds wavelengths edges[i] to edges[i + 1], uniform
// inside, and weight[i] is what a path of such a wavelength carries.
nacre_wavelength nacre_draw_wavelength(float edges[], color weight[], float u)
{
    int cells = arraylength(weight);
    int i = min((int)(u * cells), cells - 1);
    nacre_wavelength drawn = {mix(edges[i], edges[i + 1], u * cells - i), weight[i], i};
    return drawn;
}
