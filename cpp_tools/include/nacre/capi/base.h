/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_BASE_H
#define NACRE_CAPI_BASE_H

#include <stddef.h>

/**
 * @file
 * What all of the C interface shares. The rules of nacre/capi.h hold.
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

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
