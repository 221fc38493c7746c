/* SPDX-FileCopyrightText: Nacre contributors */
/* SPDX-License-Identifier: Apache-2.0 */
#ifndef NACRE_CAPI_STACKS_H
#define NACRE_CAPI_STACKS_H

#include "nacre/capi/base.h"

/**
 * @file
 * Power ratios, amplitudes and absorption of multilayers; the rules of nacre/capi.h hold.
 */
/* C names are lower case with a prefix. NOLINTBEGIN(readability-identifier-naming) */
#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif

/* NOLINTEND(readability-identifier-naming) */
