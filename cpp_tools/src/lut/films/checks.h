// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/lut/film_request.h"

namespace nacre::lut {

/// @throws InputError with everything that is wrong with a request
void check(const FilmTableRequest& request);

}  // namespace nacre::lut
