// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "nacre/oslgen/material_program.h"

namespace nacre::oslgen {

/// The shader with its `#include` lines still in it.
[[nodiscard]] std::string shader_text(const Context& context);

/// `normal` is a keyword of OSL, so the parameter of that socket has another name.
[[nodiscard]] std::string_view parameter_name(const Socket& socket);

/// Table of that name, or nothing.
[[nodiscard]] const TableInfo* find_table(const Context& context, std::string_view name);

}  // namespace nacre::oslgen
