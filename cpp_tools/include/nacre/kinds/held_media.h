// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/kinds/kind.h"
#include "nacre/media/working_range.h"

/// @file
/// Media of a template that end within the range of colours.

namespace nacre::kinds {

/// Media of a template whose data end within 360 … 830 nm, each once; the manifest has them, too.
/// @throws InputError with the template's lines, also where a medium may not be held
[[nodiscard]] std::vector<spectral::HeldEnds> held_media(const MaterialTemplate& source,
                                                         const CompileOptions& options);

}  // namespace nacre::kinds
