// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/kinds/template.h"

/// @file
/// The library's materials: templates, and hand-written shaders that say where they are listed.

namespace nacre::kinds {

/// Sorted.
[[nodiscard]] std::vector<std::string> shipped_ids();

/// Nothing where the library has no material of that id.
[[nodiscard]] std::optional<MaterialTemplate> shipped_template(std::string_view id);

}  // namespace nacre::kinds
