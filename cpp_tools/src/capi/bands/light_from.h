// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/bands/bands.h"
#include "nacre/capi/bands.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::capi {

/// @throws InputError where an array is missing; the message says `field` of values
[[nodiscard]] spectral::Spectrum samples_of(std::size_t count, const double* wavelength_nm,
                                            const double* values, const char* field);

/// @throws InputError for a light that is none
[[nodiscard]] bands::Light light_from(const nacre_light& given);

}  // namespace nacre::capi
