// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Written by write_osl_headers; do not edit. `nacre compile` puts the values in place of the names.

#define NACRE_SINUSOIDAL 0
#define NACRE_RECTANGULAR 1
#define NACRE_BLAZED 2
#define NACRE_LAST_PROFILE 2
#define NACRE_PROFILES "sinusoidal:0|rectangular:1|blazed:2"
#define NACRE_PITCH_MIN_NM 100.0
#define NACRE_PITCH_MAX_NM 1000000.0
#define NACRE_DEPTH_MAX_NM 100000.0
#define NACRE_ORDERS_MAX 9
