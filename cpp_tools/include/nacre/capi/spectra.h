/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_SPECTRA_H
#define NACRE_CAPI_SPECTRA_H

#include "nacre/capi/library.h"

/**
 * @file
 * Illuminants, colour temperature, spectra in files, and entries of the user's own library; the
 * rules of nacre/capi.h hold.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/**
 * Relative spectral power.
 * @param name   "D65", "lamp/hps", "blackbody:3200", "daylight:5600", "line:435.8@1,546.1@0.8"
 * @param power  NACRE_WAVELENGTHS
 */
NACRE_API nacre_status nacre_illuminant(const char* name, double* power);

/**
 * Colour-matching functions of the CIE.
 * @param observer  "cie1931" (2 degrees) or "cie1964" (10 degrees)
 * @param xyz       NACRE_WAVELENGTHS x 3
 */
NACRE_API nacre_status nacre_colour_matching(const char* observer, double* xyz);

/**
 * Correlated colour temperature and distance from the Planckian locus, as Ohno 2013 defines them.
 * @param XYZ    count x 3, of the CIE 1931 observer
 * @param cct_K  count; NaN where |duv| > 0.05 or outside 1000 ... 100 000 K
 * @param duv    count; positive above the locus; NaN as cct_K
 */
NACRE_API nacre_status nacre_colour_temperature(size_t count, const double* XYZ, double* cct_K,
                                                double* duv);

/** Spectra of one file. */
typedef struct nacre_spectra nacre_spectra;

/**
 * @param text  of a .csv, .spd, .spdx (IES TM-27-14) or CGATS file: by the extension of `file`,
 *              else by how it begins
 * @param file  what messages call it
 * @param kind  "emission" or "reflectance": what the values are whatever the file says; NULL or ""
 *              leaves it to the file
 * @param scale multiplies the values: 1 for ratios, 0.01 for per cent; 0 leaves it to the file. A
 *              reflectance above 1 is refused where nothing says which it is.
 */
NACRE_API nacre_status nacre_read_spectra(const char* text, size_t bytes, const char* file,
                                          const char* kind, double scale, nacre_spectra** spectra);
NACRE_API size_t nacre_spectra_count(const nacre_spectra* spectra);
/**
 * @param spectrum  key: ""; kind: "" where the file does not tell; pointers into `spectra`
 * @param tags      one a line; NULL where not wanted
 */
NACRE_API nacre_status nacre_spectra_at(const nacre_spectra* spectra, size_t index,
                                        nacre_spectrum* spectrum, const char** tags);
NACRE_API void nacre_spectra_free(nacre_spectra* spectra);

/**
 * Into the user's own library ($XDG_DATA_HOME/nacre): all or, when one is refused, none.
 * @param tags     count, each one tag a line; NULL where there are none
 * @param replace  1: in place of the user's entries of these keys. What was looked up before stays
 *                 as it was as long as the process lives.
 */
NACRE_API nacre_status nacre_library_add_spectra(size_t count, const nacre_spectrum* spectra,
                                                 const char* const* tags, int replace);
/**
 * @param text        refractiveindex.info YAML where `file` ends with .yml or .yaml, else CSV with
 *                    the columns wavelength_nm (or wavelength_um), n and perhaps k
 * @param references  citation; NULL or "": the file's own
 */
NACRE_API nacre_status nacre_library_add_medium(const char* key, const char* text, size_t bytes,
                                                const char* file, const char* references,
                                                int replace);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
