// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nacre/nacre_complex.h"

// Interfaces between isotropic media. Time factor exp(-i w t): an absorbing medium has n + i k with
// k >= 0. Verdet sign: r_p = -r_s at normal incidence.

// n cos(theta) in a medium of index n, for light whose tangential wave number is `tangential`
// (n_0 sin(theta_0)): the branch that decays, or else carries power, away from the interface.
nacre_complex nacre_forward_q(nacre_complex n, float tangential)
{
    return nacre_sqrt_upper(n * n - nacre_real(tangential * tangential));
}

nacre_complex nacre_r_s(nacre_complex q_i, nacre_complex q_t)
{
    return (q_i - q_t) / (q_i + q_t);
}

// In the form n^2 / q: n / cos(theta) up to the factor that cancels.
nacre_complex nacre_r_p(nacre_complex n_i, nacre_complex q_i, nacre_complex n_t, nacre_complex q_t)
{
    nacre_complex a = n_t * n_t * q_i;
    nacre_complex b = n_i * n_i * q_t;
    return (a - b) / (a + b);
}

// Unpolarised reflectance of one interface, from index n_i (clear) into n_t.
float nacre_reflectance(float n_i, nacre_complex n_t, float cos_i)
{
    float tangential = n_i * sqrt(max(0.0, 1.0 - cos_i * cos_i));
    nacre_complex ambient = nacre_real(n_i);
    nacre_complex q_i = nacre_real(n_i * cos_i);
    nacre_complex q_t = nacre_forward_q(n_t, tangential);
    return 0.5 * (nacre_norm(nacre_r_s(q_i, q_t)) + nacre_norm(nacre_r_p(ambient, q_i, n_t, q_t)));
}
