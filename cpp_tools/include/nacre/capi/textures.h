/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_TEXTURES_H
#define NACRE_CAPI_TEXTURES_H

#include "nacre/capi/base.h"

/**
 * @file
 * Spectra, materials and lights in textures, and FTXT; the rules of nacre/capi.h hold. Layouts:
 * nacre/spectral/spectrum_texture.h. Texels are row-major, top row first, channels interleaved.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

#define NACRE_TEXTURE_SAMPLES 512 /**< 324 ... 835 nm, every 1 nm */
#define NACRE_MATERIAL_TEXELS 516 /**< width of materials and lights */

/** A texture of the caller. */
typedef struct nacre_texture {
    int width, height, channels;
    const float* texels;
} nacre_texture;

/**
 * Samples of a spectrum; outside its data the value at its end.
 * @param reflectance  1: between six or more equal steps Sprague's interpolation; 0: linear
 * @param samples      NACRE_TEXTURE_SAMPLES
 */
NACRE_API nacre_status nacre_texture_samples(size_t count, const double* wavelength_nm,
                                             const double* values, int reflectance,
                                             double* samples);

/**
 * @param values   count x NACRE_TEXTURE_SAMPLES
 * @param layout   "packed": 128 texels of four channels a spectrum; "single": 512 of one
 * @param columns  spectra side by side
 * @param texels   ceil(count / columns) rows of columns spectra
 */
NACRE_API nacre_status nacre_pack_spectra(size_t count, const double* values, const char* layout,
                                          size_t columns, float* texels);
NACRE_API nacre_status nacre_unpack_spectra(const nacre_texture* texture, const char* layout,
                                            size_t columns, size_t count, double* values);

/**
 * @param intensity, n, k  count x NACRE_TEXTURE_SAMPLES
 * @param colours          count x 3
 * @param texels           count x NACRE_MATERIAL_TEXELS x 4
 */
NACRE_API nacre_status nacre_pack_materials(size_t count, const double* intensity, const double* n,
                                            const double* k, const double* colours, int normalise,
                                            float* texels);
NACRE_API nacre_status nacre_unpack_materials(const nacre_texture* texture, double* intensity,
                                              double* n, double* k, double* colours);

/**
 * @param power    count x NACRE_TEXTURE_SAMPLES
 * @param colours  count x 3
 * @param texels   ceil(count / 4) x NACRE_MATERIAL_TEXELS x 4
 */
NACRE_API nacre_status nacre_pack_lights(size_t count, const double* power, const double* colours,
                                         float* texels);
NACRE_API nacre_status nacre_unpack_lights(const nacre_texture* texture, size_t count,
                                           double* power, double* colours);

/** A texture as text; release it with nacre_ftxt_free(). */
typedef struct nacre_ftxt nacre_ftxt;

/** @param file  what messages call it */
NACRE_API nacre_status nacre_read_ftxt(const char* text, size_t length, const char* file,
                                       nacre_ftxt** result);
/** @param keys, values  comments, one line each; may be NULL where there are none */
NACRE_API nacre_status nacre_write_ftxt(const nacre_texture* texture, size_t comments,
                                        const char* const* keys, const char* const* values,
                                        nacre_ftxt** result);
/** As it was given, or of four channels from a text; its texels live as long as the result. */
NACRE_API nacre_status nacre_ftxt_texture(const nacre_ftxt* ftxt, nacre_texture* texture);
NACRE_API size_t nacre_ftxt_comments(const nacre_ftxt* ftxt);
/** NULL outside. */
NACRE_API const char* nacre_ftxt_key(const nacre_ftxt* ftxt, size_t index);
NACRE_API const char* nacre_ftxt_value(const nacre_ftxt* ftxt, size_t index);
/** Of the whole file. */
NACRE_API const char* nacre_ftxt_text(const nacre_ftxt* ftxt);
NACRE_API void nacre_ftxt_free(nacre_ftxt* ftxt);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
