// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/fresnel.h"

namespace nacre::optics {

Complex forward_cosine(Complex n_i, Complex n_t, Complex cos_i) noexcept
{
    if (n_i == n_t) return cos_i;
    // q² = n_t² − n_i² sin²θ_i, arranged so that nearly matched indices at grazing incidence do not
    // cancel. Of the two roots, the wave that decays; where neither does, the one that leaves.
    const Complex across = n_i * cos_i;
    Complex q = std::sqrt((n_t - n_i) * (n_t + n_i) + across * across);
    if (q.imag() < 0.0 || (q.imag() == 0.0 && q.real() < 0.0)) q = -q;
    return q / n_t;
}

FresnelAmplitudes fresnel_amplitudes(Complex n_i, Complex n_t, Complex cos_i,
                                     Complex cos_t) noexcept
{
    // At cosθ = 0 the quotients below would be 0/0 for an interface that is not there.
    if (n_i == n_t) return {.r_s = 0.0, .r_p = 0.0, .t_s = 1.0, .t_p = 1.0};

    const Complex s_i = n_i * cos_i, s_t = n_t * cos_t;
    const Complex p_i = n_t * cos_i, p_t = n_i * cos_t;
    return {.r_s = (s_i - s_t) / (s_i + s_t),
            .r_p = (p_i - p_t) / (p_i + p_t),
            .t_s = 2.0 * s_i / (s_i + s_t),
            .t_p = 2.0 * s_i / (p_i + p_t)};
}

}  // namespace nacre::optics
