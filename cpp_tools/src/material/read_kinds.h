// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "nacre/material/template.h"
#include "toml_section.h"

namespace nacre::material {

/// Reads what the material is made of: `[grating]`, `[glass]`, or else ambient, layers, substrate.
[[nodiscard]] std::variant<StackSpec, GratingSpec, GlassSpec> read_kind(Section& root);

/// Reads the one of `medium`, `n`, `cauchy`, `sellmeier`, `abbe` that the section must hold.
[[nodiscard]] MediumSpec read_medium(Section& section);

}  // namespace nacre::material
