// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_fresnel.h"

// One coherent layer by the Airy sum r = (r_01 + r_12 e) / (1 + r_01 r_12 e), e = exp(2 i delta):
// |e| <= 1 for every absorbing film, so an opaque one underflows quietly.

nacre_complex nacre_airy(nacre_complex above, nacre_complex below, nacre_complex round_trip)
{
    nacre_complex returned = below * round_trip;
    return (above + returned) / (nacre_real(1.0) + above * returned);
}

// Unpolarised reflectance of a film of index n_1 between a clear ambient n_0 and a substrate n_2.
float nacre_film_reflectance(float n_0, nacre_complex n_1, nacre_complex n_2, float thickness_nm,
                             float cos_0, float wavelength_nm)
{
    float tangential = n_0 * sqrt(max(0.0, 1.0 - cos_0 * cos_0));
    nacre_complex ambient = nacre_real(n_0);
    nacre_complex q_0 = nacre_real(n_0 * cos_0);
    nacre_complex q_1 = nacre_forward_q(n_1, tangential);
    nacre_complex q_2 = nacre_forward_q(n_2, tangential);
    nacre_complex e = nacre_exp_i(nacre_real(2.0 * M_2PI * thickness_nm / wavelength_nm) * q_1);
    nacre_complex s = nacre_airy(nacre_r_s(q_0, q_1), nacre_r_s(q_1, q_2), e);
    nacre_complex p =
        nacre_airy(nacre_r_p(ambient, q_0, n_1, q_1), nacre_r_p(n_1, q_1, n_2, q_2), e);
    return 0.5 * (nacre_norm(s) + nacre_norm(p));
}
