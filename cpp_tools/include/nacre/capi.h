/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_H
#define NACRE_CAPI_H

/**
 * @file
 * Plain C interface. Conventions (signs, units, polarisation): cpp_tools/doc/conventions.md.
 *
 * Every function that can fail returns a status; the text of the last failure of the calling thread
 * is nacre_last_error(). On failure outputs are untouched. No exception leaves the library, and all
 * functions may be called from several threads at once (one handle from one thread at a time).
 * Text is UTF-8. Complex numbers are pairs (real, imaginary).
 */

#include "nacre/capi/bands.h"
#include "nacre/capi/base.h"
#include "nacre/capi/colour.h"
#include "nacre/capi/develop.h"
#include "nacre/capi/films.h"
#include "nacre/capi/gratings.h"
#include "nacre/capi/library.h"
#include "nacre/capi/shapes.h"
#include "nacre/capi/spectra.h"
#include "nacre/capi/stack_colour.h"
#include "nacre/capi/stacks.h"
#include "nacre/capi/tables.h"
#include "nacre/capi/templates.h"
#include "nacre/capi/textures.h"
#include "nacre/capi/working_range.h"

#endif
