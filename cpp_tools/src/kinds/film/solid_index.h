// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nacre/kinds/film.h"

namespace nacre::kinds::film {

/// Index of the substrate relative to the ambient, at the d line, of a film on solid glass; nothing
/// of any other.
/// @throws InputError with the template's lines
[[nodiscard]] std::optional<double> solid_index(const MaterialTemplate& source,
                                                spectral::RangeRule rule);

}  // namespace nacre::kinds::film
