/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_COLOUR_H
#define NACRE_CAPI_COLOUR_H

#include "nacre/capi/base.h"

/**
 * @file
 * Colours of spectra and spectra of colours; the rules of nacre/capi.h hold.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct nacre_colour {
    double XYZ[3], Lab[3], rgb[3];
} nacre_colour;

/**
 * Colour of a spectrum; outside its samples the nearest one holds.
 * @param reflectance  1: reflectance or transmittance under `illuminant`; 0: emission (no
 * illuminant)
 */
NACRE_API nacre_status nacre_spectrum_to_colour(size_t count, const double* wavelength_nm,
                                                const double* values, int reflectance,
                                                const char* illuminant, const char* observer,
                                                const char* space, nacre_colour* colour);

typedef struct nacre_colour_options {
    const char *illuminant, *observer, *space; /**< illuminant: of a reflectance */
    const char* adaptation; /**< of its white to D65: "bradford" or NULL, "cat16", "none" */
    const char* gamut; /**< rgb outside [0, 1]: "keep" or NULL, "clip", "desaturate", "scale" */
    int reflectance;   /**< 1: reflectance or transmittance; 0: emission */
} nacre_colour_options;

/**
 * Colours of spectra over the same wavelengths.
 * @param values   spectra x count
 * @param colours  spectra
 */
NACRE_API nacre_status nacre_spectra_to_colours(size_t spectra, size_t count,
                                                const double* wavelength_nm, const double* values,
                                                const nacre_colour_options* options,
                                                nacre_colour* colours);

/**
 * Spectra that have given colours under D65 and the CIE 1931 observer.
 * @param rgb           count x 3, linear, of `space`
 * @param method        "jakob-hanika": values in [0, 1]; "smits"
 * @param emission      1: a light, D65 of Y = 1 through a filter of the colour
 * @param values        count x NACRE_WAVELENGTHS
 * @param coefficients  count x 3: x = (c0 nm + c1) nm + c2 of reflectance or filter
 *                      1/2 + x / (2 sqrt(1 + x^2)); NULL where not wanted, and with "smits"
 * @param error_dE00    count: of the round trip; NULL where not wanted
 */
NACRE_API nacre_status nacre_rgb_to_spectrum(size_t count, const double* rgb, const char* space,
                                             const char* method, int emission, double* values,
                                             double* coefficients, double* error_dE00);

/**
 * Reflectances of red, green and blue of Rec.709 under D65 whose sum is 1: spectra that are linear
 * in the colour.
 * @param values  NACRE_WAVELENGTHS x 3
 */
NACRE_API nacre_status nacre_rgb_basis(double* values);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
