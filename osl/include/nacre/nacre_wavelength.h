// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// One wavelength per path, for a renderer that carries only RGB.

struct nacre_wavelength {
    float nm;
    color weight;  // signed; the mean over all wavelengths is exactly (1, 1, 1)
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

// Inverse CDF over equal cells of u: cell i holds wavelengths edges[i] to edges[i + 1], uniform
// inside, and weight[i] is what a path of such a wavelength carries.
nacre_wavelength nacre_draw_wavelength(float edges[], color weight[], float u)
{
    int cells = arraylength(weight);
    int i = min((int)(u * cells), cells - 1);
    nacre_wavelength drawn = {mix(edges[i], edges[i + 1], u * cells - i), weight[i]};
    return drawn;
}
