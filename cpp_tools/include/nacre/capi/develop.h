/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_DEVELOP_H
#define NACRE_CAPI_DEVELOP_H

#include "nacre/capi/bands.h"

/**
 * @file
 * From pictures in bands to colours: for other eyes, for cameras, under other lamps; the rules of
 * nacre/capi.h hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/**
 * Bands as a spectral picture has them; release them with nacre_bands_free().
 * @param count          1 to 300
 * @param edges_nm       count + 1, ascending from 360 to 830; NULL: half way between wavelengths
 * @param wavelength_nm  count, each within its band
 * @param is_line        count: 1 where a band was made for a line; NULL: none was
 */
NACRE_API nacre_status nacre_bands_of(size_t count, const double* edges_nm,
                                      const double* wavelength_nm, const unsigned char* is_line,
                                      const char* observer, nacre_bands** bands);

/** Who looks, and what is white to them. */
typedef struct nacre_viewer {
    const char* observer;        /**< "cie1931" or "cie1964"; NULL: that of the bands */
    const char* camera;          /**< one of nacre_camera_key(), in place of an eye; NULL: none */
    size_t samples;              /**< of a camera of one's own; 0: none */
    const double* wavelength_nm; /**< samples, ascending */
    const double* sensitivity;   /**< 3 x samples: red, green and blue, >= 0 */
    int raw;                     /**< 1: channels of the camera, balanced and in no space */
    const double*
        white; /**< per nm in each band; NULL: an eye adapts to nothing, a camera to D65 */
    const char* adaptation; /**< "bradford", "cat16" or "none"; NULL: "bradford" */
    double exposure;        /**< in stops */
} nacre_viewer;

/**
 * The colour of an emission of 1 per nm in each band.
 * @param colours  count x 3: XYZ relative to D65, of which white has Y = 1 where it has that to the
 *                 eye, or channels of a raw camera
 */
NACRE_API nacre_status nacre_colours_of_bands(const nacre_bands* bands, const nacre_viewer* viewer,
                                              double* colours);

/** How many cameras there are, and their keys: `nikon-d5100`; NULL outside. */
NACRE_API size_t nacre_camera_count(void);
NACRE_API const char* nacre_camera_key(size_t index);

/**
 * By how much light in each band changes when one light takes the place of another, as bright.
 * @param power    count: of the light before, per nm in each band
 * @param name     of it, for messages
 * @param factors  count
 * Refused: a new light that shines where the old one does not.
 */
NACRE_API nacre_status nacre_exchange_light(const nacre_bands* bands, const double* power,
                                            const char* name, const nacre_light* light,
                                            double* factors);

/**
 * How far two places fall apart under another light, in dE00.
 * @param first, second  count: radiance per nm in each band
 * @param power, name    of what they are lit by, as for nacre_exchange_light()
 * @param index          where the second is first multiplied so that both are alike as they are lit
 *                       (special index of metamerism, CIE 015:2018)
 */
NACRE_API nacre_status nacre_metamerism(const nacre_bands* bands, const double* first,
                                        const double* second, const double* power, const char* name,
                                        const nacre_light* light, double* difference,
                                        double* index);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
