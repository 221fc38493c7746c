/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_LIBRARY_H
#define NACRE_CAPI_LIBRARY_H

#include "nacre/capi/base.h"

/**
 * @file
 * Entries of the library by their keys, and finding them by their words; the rules of nacre/capi.h
 * hold.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

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

enum { NACRE_MEDIA = 0, NACRE_SPECTRA = 1 }; /**< kinds of entries */

/**
 * Entries that have `text` in their key, name, chemical formula, tags or citation, whatever its
 * case, and `tag` as one whole tag. NULL or "" asks for nothing.
 * @param count  of what was found
 */
NACRE_API nacre_status nacre_library_search(int kind, const char* text, const char* tag,
                                            size_t* count);
/** Keys of the calling thread's last search, ascending; NULL past the end. */
NACRE_API const char* nacre_library_found(size_t index);

/** The pointers live as long as the process. */
typedef struct nacre_library_words {
    const char* formula; /**< chemical; "" where it has none, as every spectrum */
    const char* tags;    /**< one a line, without a line break after the last */
    const char* changes; /**< what was put right when a medium was read, one a line as tags */
} nacre_library_words;

NACRE_API nacre_status nacre_library_words_of(int kind, const char* key,
                                              nacre_library_words* words);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
