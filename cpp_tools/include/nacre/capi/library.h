/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_LIBRARY_H
#define NACRE_CAPI_LIBRARY_H

#include "nacre/capi.h"

/**
 * @file
 * Finding entries of the library by their words; the rules of nacre/capi.h hold.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

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
