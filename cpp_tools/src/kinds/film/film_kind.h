// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/kind_info.h"
#include "nacre/kinds/film.h"

namespace nacre::kinds {

template <>
KindInfo kind_info<Film>();

}  // namespace nacre::kinds
