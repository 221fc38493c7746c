/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_SHAPES_H
#define NACRE_CAPI_SHAPES_H

#include "nacre/capi/base.h"

/**
 * @file
 * Spectra made by hand, as sums of simple shapes; the conventions of capi.h.
 */

/* NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

typedef enum nacre_shape_kind {
    NACRE_CONSTANT = 0, /**< numbers: value */
    NACRE_BOX = 1, /**< numbers: first_nm, last_nm, value, edge_nm: between the two wavelengths,
                        rising and falling over so many nm along half a cosine; 0 elsewhere */
    NACRE_GAUSSIAN = 2, /**< numbers: centre_nm, full width at half maximum in nm, peak */
    NACRE_LINEAR = 3,   /**< straight between control points, beyond them the nearest value */
    NACRE_SMOOTH = 4,   /**< the same along a cubic that is monotone wherever they are (Fritsch and
                             Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300) */
    NACRE_SCALED = 5    /**< numbers: factor, times the spectrum `key` of the library or, where that
                             is NULL, the one that the arrays and `of_kind` give */
} nacre_shape_kind;

typedef struct nacre_shape {
    nacre_shape_kind kind;
    double numbers[4];           /**< as `kind` has them; the rest is not looked at */
    size_t count;                /**< of the two arrays */
    const double* wavelength_nm; /**< ascending; NULL where `kind` needs none */
    const double* values;
    const char* key;
    const char* of_kind; /**< "emission" or "reflectance", which says how to interpolate */
} nacre_shape;

/**
 * The sum of shapes at each wavelength. Values of a shape may be negative.
 * @param kind           "emission" or "reflectance", which the sum has to suit: >= 0 and somewhere
 *                       > 0, or in [0, 2]; NULL where anything will do
 * @param wavelength_nm  count, two or more, ascending
 * @param values         count
 * Refused: a box or a Gaussian so narrow that it falls between the wavelengths.
 */
NACRE_API nacre_status nacre_sum_of_shapes(size_t shapes, const nacre_shape* shape,
                                           const char* kind, size_t count,
                                           const double* wavelength_nm, double* values);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming) */

#endif
