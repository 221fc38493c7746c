// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Indices of clear media over wavelength.

// n^2 = 1 + sum b l^2 / (l^2 - c), wavelength in um, c in um^2.
float nacre_sellmeier(float b[], float c[], float wavelength_nm)
{
    float l2 = wavelength_nm * wavelength_nm * 1e-6;
    float n2 = 1.0;
    for (int i = 0; i < arraylength(b); i++) n2 += b[i] * l2 / (l2 - c[i]);
    return sqrt(n2);
}

// n = a + b / l^2 + c / l^4, wavelength in um.
float nacre_cauchy(float a, float b, float c, float wavelength_nm)
{
    float inverse = 1e6 / (wavelength_nm * wavelength_nm);
    return a + inverse * (b + inverse * c);
}

// Cubic through the four nearest of equally spaced knots, of which the first belongs to `first_nm`.
float nacre_index(float knots[], float first_nm, float step_nm, float wavelength_nm)
{
    float x = (wavelength_nm - first_nm) / step_nm;
    int i = clamp((int)floor(x) - 1, 0, arraylength(knots) - 4);
    float t = x - i;
    return ((1.0 - t) * (t - 2.0) * (t - 3.0) * knots[i] * (1.0 / 6.0)) +
           (t * (t - 2.0) * (t - 3.0) * knots[i + 1] * 0.5) +
           (t * (1.0 - t) * (t - 3.0) * knots[i + 2] * 0.5) +
           (t * (t - 1.0) * (t - 2.0) * knots[i + 3] * (1.0 / 6.0));
}

// Spectral lines d, F and C of helium and hydrogen, which define n_d and the Abbe number.
#define NACRE_LINE_D_NM 587.5618
#define NACRE_LINE_F_NM 486.1327
#define NACRE_LINE_C_NM 656.2725

// b of n = a + b / l^2 (um^2) for an Abbe number v_d = (n_d - 1) / (n_F - n_C).
float nacre_abbe_slope(float n_d, float v_d)
{
    float spread =
        1e6 / (NACRE_LINE_F_NM * NACRE_LINE_F_NM) - 1e6 / (NACRE_LINE_C_NM * NACRE_LINE_C_NM);
    return (n_d - 1.0) / (v_d * spread);
}
