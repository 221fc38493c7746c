/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_TEMPLATES_H
#define NACRE_CAPI_TEMPLATES_H

#include "nacre/capi/bands.h"
#include "nacre/capi/tables.h"

/**
 * @file
 * Templates to materials, and the film of one while it is edited; the rules of nacre/capi.h hold.
 * `adaptation` is that of nacre_compile_template().
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/**
 * Template text to compiled material; `file` is what messages call it, `adaptation` that of
 * nacre_colour_options (nacre/capi/colour.h) or NULL.
 */
NACRE_API nacre_status nacre_compile_template(const char* text, const char* file,
                                              const char* illuminant, const char* observer,
                                              const char* space, const char* adaptation,
                                              double tolerance, nacre_result** result);

/** A table that a compiled material has, as its manifest states it. */
typedef struct nacre_table_size {
    const char* name;
    int width, height;
} nacre_table_size;

/**
 * Tables of these names and sizes for a film that is being edited, quickly and without stated
 * errors; `R_further`, `R_schlick` and `lobe_...` are left out.
 */
NACRE_API nacre_status nacre_preview_template(const char* text, const char* file,
                                              const char* illuminant, const char* observer,
                                              const char* space, const char* adaptation,
                                              size_t count, const nacre_table_size* sizes,
                                              nacre_result** result);

/**
 * Tables of these names and sizes, those of a compiled film, where the three channels of a render
 * are three bands: texels are the reflectance in each, and pass lies below pass, so that a table is
 * `passes` times as high. `R_schlick` and `lobe_...` are left out.
 * @param band  passes x 3: indices into the bands
 */
NACRE_API nacre_status nacre_band_tables(const char* text, const char* file,
                                         const nacre_bands* bands, size_t passes,
                                         const size_t* band, size_t count,
                                         const nacre_table_size* sizes, nacre_result** result);

/** Of the film of a template at its thickest: the sum of index times thickness of its layers. */
NACRE_API nacre_status nacre_template_optical_thickness(const char* text, const char* file,
                                                        double* thickness_nm);

/**
 * Reflectance of the film of a template at thicknesses from 0.9 times its thickest to that, evenly,
 * which nacre_band_needs takes; of one that does not vary all the same.
 * @param count        > 1
 * @param angle_deg    of incidence, from 0 to below 90, in the ambient
 * @param reflectance  count x NACRE_WAVELENGTHS, 360 ... 830 nm
 */
NACRE_API nacre_status nacre_template_fringes(const char* text, const char* file, size_t count,
                                              double angle_deg, double* reflectance);

/**
 * What the film of a template reflects and lets pass, unpolarised.
 * @param value         of what varies, nm or a factor; not held to its range
 * @param angle_deg     in the ambient, in [0, 90)
 * @param reflectance   NACRE_WAVELENGTHS, 360 ... 830 nm; `transmittance` too
 * @param colours       2 x 3: of both, in the space
 */
NACRE_API nacre_status nacre_template_spectrum(const char* text, const char* file,
                                               const char* illuminant, const char* observer,
                                               const char* space, const char* adaptation,
                                               double value, double angle_deg, double* reflectance,
                                               double* transmittance, double* colours);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
