// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "nacre/material/head.h"

/// @file
/// The template: the one source of a material, as the author wrote it.

namespace nacre::kinds {

class Kind;

struct MaterialTemplate : material::TemplateHead {
    std::shared_ptr<const Kind> kind;  ///< what the material is made of
};

/// @param file  what to call the input in messages
/// @throws InputError with every problem of the file, each with its line.
[[nodiscard]] MaterialTemplate parse_template(std::string_view toml, std::string_view file);

/// JSON Schema (draft 2020-12) of the format, for editors; `nacre library schema` prints it.
[[nodiscard]] std::string template_json_schema();

}  // namespace nacre::kinds
