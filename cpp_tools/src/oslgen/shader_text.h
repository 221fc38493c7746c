// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/oslgen/material_program.h"

namespace nacre::oslgen {

/// The shader with its `#include` lines still in it.
[[nodiscard]] std::string shader_text(const Context& context);

/// `normal` is a keyword of OSL, so the parameter of that socket has another name.
[[nodiscard]] std::string_view parameter_name(const Socket& socket);

/// Table of that name, or nothing.
[[nodiscard]] const TableInfo* find_table(const Context& context, std::string_view name);

/// Names of the colours that the node graph may look up for the shader: one for each table but the
/// rough ones, which are mixed into the smooth, and one for each coefficient of R_schlick.
[[nodiscard]] std::vector<std::string> looked_up_colours(const Context& context);

/// Whether the coverage fades `name` to the bare substrate.
[[nodiscard]] bool has_bare(const Context& context, std::string_view name);

}  // namespace nacre::oslgen
