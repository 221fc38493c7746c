// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/kind.h"

namespace nacre::kinds {

Kind::~Kind() = default;

}  // namespace nacre::kinds
