// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/bands/bands.h"

struct nacre_bands {
    nacre::bands::Bands made;
};
