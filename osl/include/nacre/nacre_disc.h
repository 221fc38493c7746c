// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_grating.h"
#include "nacre/nacre_surface.h"
#include "nacre/nacre_view.h"
#include "nacre/nacre_wavelength.h"

// A reflecting disc with concentric tracks around the object's z axis.

struct nacre_disc_tracks {
    int profile;  // of the grooves, see nacre_grating
    float pitch_nm;
    float depth_nm;
    float duty;
    float cover_index;  // of what fills the grooves
    int orders;
    float strength;  // share of the diffracted light that is kept
};

// Unit vector across the tracks at P, tangential to the surface.
vector nacre_across_tracks(normal n)
{
    vector radial = transform("object", P) - point(0.0);
    radial[2] = 0.0;
    vector across = transform("object", "world", radial);
    return normalize(across - n * dot(n, across));
}

// Light crosses the grooves twice, under the cosine that it has inside the cover.
nacre_grating nacre_disc_grating(nacre_disc_tracks disc, vector lateral, float wavelength_nm)
{
    float inside = sqrt(1.0 - dot(lateral, lateral) / (disc.cover_index * disc.cover_index));
    float path_nm = 2.0 * disc.cover_index * disc.depth_nm * inside;
    nacre_grating grating = {disc.profile, M_2PI * path_nm / wavelength_nm, disc.duty};
    return grating;
}

// The mirror image needs no wavelength of its own: its colour is the weighted mean over all of
// them. The share of order zero is smooth, so four cells of the path's wavelength make one step.
color nacre_disc_mirror(nacre_disc_tracks disc, vector lateral, vector across, color tint,
                        float edges[], color weight[], color basis[])
{
    int cells = arraylength(weight);
    color sum = 0.0;
    for (int i = 0; i + 4 <= cells; i += 4) {
        float nm = edges[i + 2];
        nacre_grating grating = nacre_disc_grating(disc, lateral, nm);
        float share = nacre_efficiency(grating, 0) /
                      nacre_propagating_share(grating, lateral, across, nm / disc.pitch_nm);
        color step = 0.0;
        for (int j = i; j < i + 4; j++) step += weight[j] * nacre_at_wavelength(tint, basis[j]);
        sum += step * (1.0 + disc.strength * (share - 1.0));
    }
    return sum / cells;
}

// Every order is a mirror lobe around the normal that sends the path where the grating equation
// wants it; `I` points to the viewer in Cycles. Sums run to the right, as `lobe + sum`: a long sum
// the other way loses lobes.
closure color nacre_disc_lobes(nacre_disc_tracks disc, normal n, float roughness, color tint,
                               float edges[], color weight[], color basis[])
{
    vector lateral = n * dot(n, NACRE_TO_VIEWER) - NACRE_TO_VIEWER;
    vector across = nacre_across_tracks(n);
    float random = nacre_second_random(nacre_path_random(), arraylength(weight));
    nacre_wavelength path = nacre_draw_wavelength(edges, weight, random);
    float ratio = path.nm / disc.pitch_nm;
    nacre_grating grating = nacre_disc_grating(disc, lateral, path.nm);
    float scale = disc.strength / nacre_propagating_share(grating, lateral, across, ratio);

    color light = path.weight * nacre_at_wavelength(tint, basis[path.cell]);
    color mirror = nacre_disc_mirror(disc, lateral, across, tint, edges, weight, basis);
    closure color sum = nacre_reflection(n, mirror, roughness);
    for (int m = -disc.orders; m <= disc.orders; m++) {
        vector out = nacre_order_direction(lateral, across, ratio, m);
        float lateral_squared = dot(out, out);
        if (m == 0 || lateral_squared >= 1.0) continue;
        normal tilted = normalize(out + n * sqrt(1.0 - lateral_squared) + NACRE_TO_VIEWER);
        color order_tint = light * (scale * nacre_efficiency(grating, m));
        sum = nacre_reflection(tilted, order_tint, roughness) + sum;
    }
    return sum;
}
