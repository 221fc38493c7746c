// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "nacre/nacre_constants.h"

// Plane reflection gratings in any orientation, scalar theory.

// One period as a phase object; `phase` is the peak-to-valley phase of the light.
struct nacre_grating {
    int profile;  // 0 sinusoidal, 1 rectangular, 2 blazed
    float phase;
    float duty;  // raised share of the period, rectangular only
};

// J_m(x) as the mean of cos(m t - x sin t) over a period: the trapezoidal rule of 48 points errs by
// J_(48-m)(x), below single precision for x < 12 and m < 10.
float nacre_bessel(int m, float x)
{
    float sum = 0.0;
    for (int i = 0; i < 48; i++) {
        float t = M_2PI * i / 48.0;
        sum += cos(m * t - x * sin(t));
    }
    return sum / 48.0;
}

float nacre_sinc(float x)
{
    return fabs(x) < 1e-4 ? 1.0 : sin(M_PI * x) / (M_PI * x);
}

// Share of order m in the reflected light; the sum over all m is 1.
float nacre_efficiency(nacre_grating grating, int m)
{
    float amplitude = 0.0;
    if (grating.profile == NACRE_SINUSOIDAL)
        amplitude = nacre_bessel(m, 0.5 * grating.phase);
    else if (grating.profile == NACRE_BLAZED)
        amplitude = nacre_sinc(grating.phase / M_2PI - m);
    else if (m == 0)
        return 1.0 - 2.0 * grating.duty * (1.0 - grating.duty) * (1.0 - cos(grating.phase));
    else
        amplitude = 2.0 * sin(0.5 * grating.phase) * grating.duty * nacre_sinc(m * grating.duty);
    return amplitude * amplitude;
}

// Tangential direction of order m: the grating equation in conical mounting. `lateral` is the
// tangential part of the incoming direction, `across` the unit vector across the grooves, `ratio`
// wavelength / pitch. The order propagates where the result is shorter than 1.
vector nacre_order_direction(vector lateral, vector across, float ratio, int m)
{
    return lateral + m * ratio * across;
}

// Share of all light that scalar theory puts into orders that propagate; the others' light goes to
// these in proportion.
float nacre_propagating_share(nacre_grating grating, vector lateral, vector across, float ratio)
{
    float share = 0.0;
    int last = (int)floor((1.0 + length(lateral)) / ratio);
    for (int m = -last; m <= last; m++) {
        vector out = nacre_order_direction(lateral, across, ratio, m);
        if (dot(out, out) < 1.0) share += nacre_efficiency(grating, m);
    }
    return share;
}
