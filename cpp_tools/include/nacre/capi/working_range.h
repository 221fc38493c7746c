/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_WORKING_RANGE_H
#define NACRE_CAPI_WORKING_RANGE_H

#include "nacre/capi/base.h"

/**
 * @file
 * Media over 360 ... 830 nm, the range of colours; the rules of nacre/capi.h hold.
 *
 * Wherever a template or a key stands for a medium of a stack, data of 400 ... 700 nm are enough:
 * where they end within 360 ... 830 nm, n and k are held as they are at the end. `strict_range` of
 * 1 refuses such data here, so a program that wants none of them asks before it computes.
 */

/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

/** @param n  NACRE_WAVELENGTHS pairs n, k */
NACRE_API nacre_status nacre_library_index_on_grid(const char* key, int strict_range, double* n);

/**
 * What is held of a medium.
 * @param percent  of the luminous weight under `illuminant`; 0 where nothing is held
 * @param note     a sentence that says so, "" where nothing is held; lives as long as the process;
 *                 NULL where not wanted
 */
NACRE_API nacre_status nacre_library_held_ends(const char* key, const char* illuminant,
                                               const char* observer, int strict_range,
                                               double* percent, const char** note);

/**
 * The same of all media of a template; the manifest of a compiled material lists them, too.
 * @param notes  one a line, without a line break after the last; "" where nothing is held; lives as
 *               long as the process
 */
NACRE_API nacre_status nacre_template_held_ends(const char* text, const char* file,
                                                const char* illuminant, const char* observer,
                                                int strict_range, const char** notes);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
