// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "nacre/kinds/film.h"
#include "nacre/oslgen/program.h"

namespace nacre::kinds::film {

/// What reads the tables of a film.
/// @param solid_index  of a film on solid glass
/// @param powers       of any other
[[nodiscard]] oslgen::Program program(const MaterialTemplate& source,
                                      std::span<const lut::Table> tables,
                                      std::optional<double> solid_index,
                                      std::optional<oslgen::PowerLobes> powers);

}  // namespace nacre::kinds::film
