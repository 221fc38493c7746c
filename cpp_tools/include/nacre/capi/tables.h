/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_TABLES_H
#define NACRE_CAPI_TABLES_H

#include "nacre/capi/base.h"

/**
 * @file
 * Tables and texts that calls make; the rules of nacre/capi.h hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

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

NACRE_API size_t nacre_result_tables(const nacre_result* result);
/** The pointers live as long as the result. */
NACRE_API nacre_status nacre_result_table(const nacre_result* result, size_t index,
                                          nacre_table* table);
/** "id", "osl" or "manifest" of a compiled material; NULL for anything else. */
NACRE_API const char* nacre_result_text(const nacre_result* result, const char* name);
NACRE_API void nacre_result_free(nacre_result* result);

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
