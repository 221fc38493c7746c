// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/material/head.h"

namespace nacre::kinds::glass {

inline constexpr material::SliderInfo kDispersion{
    .name = "dispersion",
    .label = "Dispersion",
    .help = "0: the index of the d line for every wavelength, 1: as measured",
    .value = 1.0,
    .max = 5.0,
    .most = 10.0};

}  // namespace nacre::kinds::glass
