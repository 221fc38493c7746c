/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_GRATINGS_H
#define NACRE_CAPI_GRATINGS_H

#include "nacre/capi/base.h"

/**
 * @file
 * Diffraction by gratings and slits; the rules of nacre/capi.h hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct nacre_grating {
    double pitch_nm, wavelength_nm;
    double grating_vector[3], normal[3], k_in[3];
    const char* profile; /**< "sinusoidal", "rectangular", "blazed" */
    double phase_rad, duty;
} nacre_grating;

/**
 * Orders first ... last of a plane reflection grating.
 * @param directions    (last - first + 1) x 3; zeros where the order does not propagate
 * @param efficiencies  last - first + 1
 */
NACRE_API nacre_status nacre_grating_orders(const nacre_grating* grating, int first, int last,
                                            double* directions, double* efficiencies);

/**
 * Intensity far behind slits, 1 straight ahead.
 * @param slits      count x 4: width_nm, spacing_nm (0: one slit), angle_deg, wavelength_nm
 * @param intensity  count
 */
NACRE_API nacre_status nacre_slit_intensity(size_t count, const double* slits, double* intensity);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
