// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tuple>

#include "glass/glass.h"
#include "grating/grating.h"
#include "nacre/kinds/film.h"

namespace nacre::kinds {

/// The one list of kinds, in the order of the documentation.
using AllKinds = std::tuple<Film,     //
                            Grating,  //
                            Glass>;

}  // namespace nacre::kinds
