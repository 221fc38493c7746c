// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "nacre/kinds/template.h"

/// @file
/// Templates of every kind, read.

namespace nacre::kinds {

/// @param text  TOML; or OSL, of a shader whose metadata say what a template's head does
/// @param file  what to call the input in messages
/// @throws InputError with every problem of the file, each with its line.
[[nodiscard]] MaterialTemplate parse_template(std::string_view text, std::string_view file);

/// JSON Schema (draft 2020-12) of the format in TOML, for editors; `nacre library schema` prints
/// it.
[[nodiscard]] std::string template_json_schema();

}  // namespace nacre::kinds
