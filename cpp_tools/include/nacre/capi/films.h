/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_FILMS_H
#define NACRE_CAPI_FILMS_H

#include "nacre/capi/base.h"
#include "nacre/capi/tables.h"

/**
 * @file
 * One film: closed forms, and tables of its colours; the rules of nacre/capi.h hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/** One clear film on a base, and its light. */
typedef struct nacre_film_query {
    double n_ambient, n_film, n_base, k_base;
    double d_nm, angle_deg, wavelength_nm;
    double mirror_reflectance; /**< of "etalon": in [0, 1); negative: the faces' own */
} nacre_film_query;

/**
 * Closed forms of one film.
 * @param model   "path_difference", "airy", "series", "opaque_base", "free_film", "etalon" or
 *                "recursion"
 * @param R       count
 */
NACRE_API nacre_status nacre_film_reflectance(const char* model, size_t count,
                                              const nacre_film_query* films,
                                              nacre_polarisation polarisation, double* R);

typedef struct nacre_film {
    size_t layers;
    const double* n;               /**< (layers + 2) x NACRE_WAVELENGTHS pairs */
    const double* d_nm;            /**< layers */
    const unsigned char* coherent; /**< layers; NULL: all coherent */
    int varying;     /**< index of a layer; -1: factor on all coherent layers; -2: nothing */
    double min, max; /**< nm, or a factor */
    const char *illuminant, *observer, *space;
    const char* adaptation; /**< of nacre_colour_options; NULL: "bradford" */
    double tolerance;  /**< dE00; decides the size; 0 with a size: errors are not measured (NaN) */
    int width, height; /**< > 0: this size instead */
    int transmittance; /**< 1: also bake T */
    int single_precision; /**< 1: faster, colours good to 1e-5; where errors are not measured */
} nacre_film;

NACRE_API nacre_status nacre_film_lut(const nacre_film* film, nacre_result** result);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
