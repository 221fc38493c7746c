/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_BANDS_H
#define NACRE_CAPI_BANDS_H

#include "nacre/capi/base.h"

/**
 * @file
 * Spectra as a few numbers, three of which a renderer takes at a time; the rules of nacre/capi.h
 * hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/** A light: by its name, or by samples and lines, where there are any. */
typedef struct nacre_light {
    const char* name;            /**< as nacre_illuminant(), or what messages call it */
    size_t count;                /**< of samples, linear in between, the nearest one outside */
    const double* wavelength_nm; /**< ascending */
    const double* power;         /**< per nm, >= 0 */
    size_t lines;
    const double* line_nm;
    const double* line_power; /**< of a whole line, > 0 */
} nacre_light;

/** Bands; release them with nacre_bands_free(). */
typedef struct nacre_bands nacre_bands;

/**
 * Bands for some lights together. Half of what spaces them is the eye, the other half the lights.
 * Each line has a band of its own, at its wavelength.
 * @param count     at most 300, and a band for each line and for what is between two of them
 * @param light     lights; NULL with none
 * @param observer  "cie1931" or "cie1964"
 */
NACRE_API nacre_status nacre_bands_make(size_t count, size_t lights, const nacre_light* light,
                                        const char* observer, nacre_bands** bands);

/** What a scene has, and how well its colours should come out. */
typedef struct nacre_band_needs {
    size_t lights;
    const nacre_light* light;
    size_t samples;              /**< of reflectances, films and spreads */
    const double* wavelength_nm; /**< samples, ascending */
    size_t reflectances;         /**< 0: those of the library */
    const double* reflectance;   /**< reflectances x samples */
    size_t films;
    const double* film_nm; /**< films: optical thickness, index times thickness */
    /** films x samples, those of one optical thickness together; NULL: fringes of full contrast */
    const double* film_reflectance;
    size_t spreads; /**< of dispersive things */
    const double*
        spread_px; /**< spreads x samples: where in an image light of each wavelength lies */
    double mean_error, max_error; /**< dE00, > 0 */
} nacre_band_needs;

typedef struct nacre_band_choice {
    int passes;                   /**< of three bands */
    double mean_error, max_error; /**< dE00 of reflectances under the light that is worst off */
    double film_error;            /**< mean dE00 of films, likewise */
    double step_px;   /**< the widest step of a spread that is bright enough to be seen */
    const char* held; /**< what is nearest to its limit: "lights", "lines", "films", "spreads" */
    int met;          /**< 0: 100 passes, the most, are not enough */
} nacre_band_choice;

/** The fewest passes, of some from 8 to 100, that are within the errors. */
NACRE_API nacre_status nacre_bands_choose(const nacre_band_needs* needs, const char* observer,
                                          nacre_bands** bands, nacre_band_choice* choice);

NACRE_API size_t nacre_bands_count(const nacre_bands* bands);
/**
 * @param edges_nm       count + 1, from 360 to 830
 * @param wavelength_nm  count: what surfaces are looked up at
 * @param xyz            count x 3: colour of an emission of 1 per nm in the band
 * @param is_line        count: 1 where a band was made for a line; NULL where not wanted
 */
NACRE_API nacre_status nacre_bands_get(const nacre_bands* bands, double* edges_nm,
                                       double* wavelength_nm, double* xyz, unsigned char* is_line);

/**
 * Power per nm of a light in each band: near its mean there, and such that colours of smooth
 * reflectances come out right; white to 1e-5.
 * @param power  nacre_bands_count()
 */
NACRE_API nacre_status nacre_light_in_bands(const nacre_bands* bands, const nacre_light* light,
                                            double* power);

/**
 * dE00 of reflectances under a light between the sum over bands and that over 0.1 nm.
 * @param reflectance  reflectances x samples
 */
NACRE_API nacre_status nacre_band_error(const nacre_bands* bands, const nacre_light* light,
                                        size_t samples, const double* wavelength_nm,
                                        size_t reflectances, const double* reflectance,
                                        double* mean, double* max);

NACRE_API void nacre_bands_free(nacre_bands* bands);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
