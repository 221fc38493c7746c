// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/pipeline/compile.h"

namespace nacre::capi {

struct ColourNames {
    const char *illuminant, *observer, *space;
    const char* adaptation = nullptr;
};

/// For the colours of a template; refuses what is missing.
kinds::CompileOptions compile_options(const char* text, const char* file,
                                      const ColourNames& colour);

}  // namespace nacre::capi
