/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_H
#define NACRE_CAPI_H

#include <stddef.h>

/**
 * @file
 * Plain C interface. Conventions (signs, units, polarisation): cpp_tools/doc/conventions.md.
 *
 * Every function that can fail returns a status; the text of the last failure of the calling thread
 * is nacre_last_error(). On failure outputs are untouched. No exception leaves the library, and all
 * functions may be called from several threads at once (one handle from one thread at a time).
 * Text is UTF-8. Complex numbers are pairs (real, imaginary).
 */

#if defined(_WIN32)
#define NACRE_API __declspec(dllexport)
#else
#define NACRE_API __attribute__((visibility("default")))
#endif

/** Grows when a function or a structure changes; additions do not count. */
#define NACRE_API_VERSION 1
/** Wavelengths of every table: 360 ... 830 nm, every 1 nm. */
#define NACRE_WAVELENGTHS 471

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

typedef enum nacre_status {
    NACRE_OK = 0,
    NACRE_INPUT = 1,   /**< wrong input: nacre_last_error() names the field */
    NACRE_MEMORY = 2,  /**< out of memory */
    NACRE_INTERNAL = 3 /**< a mistake in Nacre */
} nacre_status;

typedef enum nacre_polarisation {
    NACRE_S = 0,
    NACRE_P = 1,
    NACRE_UNPOLARISED = 2
} nacre_polarisation;

NACRE_API int nacre_api_version(void);
NACRE_API const char* nacre_version(void);
NACRE_API const char* nacre_last_error(void);

/** How light interferes in each layer; NULL in place of one of these: fully, in all layers. */
typedef struct nacre_coherence {
    const unsigned char* coherent; /**< layers: 0 where intensities are added; NULL: 1 everywhere */
    const double* spread_nm; /**< layers: standard deviation of the thickness within what is looked
                                  at; NULL: 0 everywhere */
    double bandwidth_nm;     /**< Gaussian, full width at half maximum */
} nacre_coherence;

/**
 * Power ratios, amplitudes and absorption of `count` stacks of `layers` layers each.
 *
 * @param n              count x (layers + 2) pairs, ambient to substrate
 * @param d_nm           count x layers
 * @param angle_deg      count, in [0, 90), in the ambient
 * @param wavelength_nm  count, in vacuum
 * @param power          count x 3: R, T, A
 * @param amplitudes     count x 2 pairs: r, t; NULL where not wanted. Only s or p, fully coherent.
 * @param absorption     count x layers: what each layer absorbs; NULL where not wanted. Only
 *                       without spread and bandwidth.
 */
NACRE_API nacre_status nacre_stack(size_t count, size_t layers, const double* n, const double* d_nm,
                                   const double* angle_deg, const double* wavelength_nm,
                                   const nacre_coherence* coherence,
                                   nacre_polarisation polarisation, double* power,
                                   double* amplitudes, double* absorption);

/** One argument of nacre_stack_grid(). */
typedef struct nacre_grid_array {
    const double* values;
    const size_t*
        steps; /**< axes: elements from one item to the next along each axis; 0: the same */
} nacre_grid_array;

/**
 * nacre_stack() for a grid of items, each argument stored once however many items share it. The
 * last axis runs fastest in the results. Several threads work on a large grid; the bits do not
 * depend on it, nor on how the items are arranged.
 *
 * @param shape  axes; results have the product of it as their count
 * @param n      elements of (layers + 2) pairs
 * @param d_nm   elements of `layers` numbers
 */
NACRE_API nacre_status nacre_stack_grid(size_t axes, const size_t* shape, size_t layers,
                                        nacre_grid_array n, nacre_grid_array d_nm,
                                        nacre_grid_array angle_deg, nacre_grid_array wavelength_nm,
                                        const nacre_coherence* coherence,
                                        nacre_polarisation polarisation, double* power,
                                        double* amplitudes, double* absorption);

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

/**
 * Intensity far behind slits, 1 straight ahead.
 * @param slits      count x 4: width_nm, spacing_nm (0: one slit), angle_deg, wavelength_nm
 * @param intensity  count
 */
NACRE_API nacre_status nacre_slit_intensity(size_t count, const double* slits, double* intensity);

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

/** Tables and texts that a call made; release it with nacre_result_free(). */
typedef struct nacre_result nacre_result;

typedef struct nacre_table {
    const char *name, *quantity; /**< "R", "reflectance" */
    const char *x_name, *y_name; /**< "cos_theta", "thickness_nm" */
    double x_min, x_max, y_min, y_max;
    int width, height, channels;
    double error_max, error_mean; /**< measured between texels, dE00, angles up to 87 degrees */
    const float* texels;          /**< height x width x channels; row 0 holds y_min */
} nacre_table;

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

/**
 * Template text to compiled material; `file` is what messages call it, `adaptation` that of
 * nacre_colour_options (nacre/capi/colour.h) or NULL.
 */
NACRE_API nacre_status nacre_compile_template(const char* text, const char* file,
                                              const char* illuminant, const char* observer,
                                              const char* space, const char* adaptation,
                                              double tolerance, nacre_result** result);

NACRE_API size_t nacre_result_tables(const nacre_result* result);
/** The pointers live as long as the result. */
NACRE_API nacre_status nacre_result_table(const nacre_result* result, size_t index,
                                          nacre_table* table);
/** "id", "osl" or "manifest" of a compiled material; NULL for anything else. */
NACRE_API const char* nacre_result_text(const nacre_result* result, const char* name);
NACRE_API void nacre_result_free(nacre_result* result);

/**
 * Media that come with Nacre and the user's own ($XDG_DATA_HOME/nacre), in ascending order of their
 * keys. The count looks anew and the keys are those of the calling thread's last count.
 */
NACRE_API size_t nacre_library_count(void);
NACRE_API const char* nacre_library_key(size_t index); /**< NULL past the end */

typedef struct nacre_medium {
    const char *key, *name, *references, *comments;
    double first_nm, last_nm; /**< range of the data; 0 and infinity for a constant */
} nacre_medium;

NACRE_API nacre_status nacre_library_medium(const char* key, nacre_medium* medium);
/** @param n  count pairs */
NACRE_API nacre_status nacre_library_index(const char* key, size_t count,
                                           const double* wavelength_nm, double* n);

/** Spectra, counted and listed as the media are. */
NACRE_API size_t nacre_library_spectrum_count(void);
NACRE_API const char* nacre_library_spectrum_key(size_t index); /**< NULL past the end */

/** The pointers live as long as the process. */
typedef struct nacre_spectrum {
    const char *key, *name;
    const char* kind; /**< "emission" or "reflectance" */
    const char *references, *licence, *comments;
    size_t count;
    const double *wavelength_nm, *values;
} nacre_spectrum;

NACRE_API nacre_status nacre_library_spectrum(const char* key, nacre_spectrum* spectrum);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
