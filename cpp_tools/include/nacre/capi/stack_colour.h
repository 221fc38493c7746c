/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_STACK_COLOUR_H
#define NACRE_CAPI_STACK_COLOUR_H

#include "nacre/capi/colour.h"

/**
 * @file
 * Colours of many multilayers of the same media, from as few wavelengths as they take; the rules of
 * nacre/capi.h hold.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/** A medium by its key in the library, or by numbers. */
typedef struct nacre_medium_index {
    const char* key; /**< held as nacre/capi/working_range.h has it; or NULL, and then */
    const double* n; /**< `count` pairs n, k */
    size_t count;    /**< 1, or NACRE_WAVELENGTHS for 360 ... 830 nm, linear in between */
} nacre_medium_index;

typedef struct nacre_colour_stacks {
    size_t layers;
    const nacre_medium_index* media; /**< layers + 2, from the ambient, which is clear */
    const unsigned char* coherent;   /**< layers; NULL: all coherent */
    size_t count;                    /**< of stacks */
    const double* d_nm;              /**< count x layers */
    const double* angle_deg;         /**< count: in the ambient, in [0, 90) */
    nacre_polarisation polarisation;
    const char* sampling; /**< "adaptive" or NULL, "full" (1 nm), "reference" (0.05 nm), "steps:N",
                               "hierarchical:LEVEL" */
} nacre_colour_stacks;

/**
 * @param options        `reflectance` is not read
 * @param reflectance    count; NULL where not wanted
 * @param transmittance  count; NULL where not wanted
 * @param wavelengths    count: at how many each stack was computed; NULL where not wanted
 */
NACRE_API nacre_status nacre_stack_colours(const nacre_colour_stacks* stacks,
                                           const nacre_colour_options* options,
                                           nacre_colour* reflectance, nacre_colour* transmittance,
                                           size_t* wavelengths);

/**
 * All colours of an image, or of a list, together.
 * @param rgb    count x 3, changed in place
 * @param range  "none", "clamp" each channel into [0, 1], "normalise" by the largest channel of all
 */
NACRE_API nacre_status nacre_map_range(size_t count, double* rgb, const char* range);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
