// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "nacre/kinds/film.h"
#include "nacre/lut/film_table.h"

namespace nacre::kinds::film {

/// The technique that a film asks for. What a form takes for clear loses its trace of k.
/// @throws InputError with the template's lines where the stack is outside its domain
[[nodiscard]] std::optional<lut::Technique> technique(const Film& film, lut::SampledStack& stack,
                                                      const std::string& file);

}  // namespace nacre::kinds::film
