// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nacre/kinds/film.h"

/// @file
/// The two forms of a film stack: a template (.toml), and the JSON that every table carries, which
/// has the template's keys.

namespace nacre::tool {

/// Parses a template (.toml) or its JSON (.json, or `-` for the standard input), where
/// `schema` and `material` may be left out.
/// @throws InputError with every problem
[[nodiscard]] kinds::MaterialTemplate read_template_input(const std::string& file);

/// Ambient, layers, substrate and what varies, as JSON.
[[nodiscard]] std::string stack_json(const kinds::MaterialTemplate& source);

}  // namespace nacre::tool
