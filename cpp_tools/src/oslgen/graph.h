// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "nacre/oslgen/material_program.h"

namespace nacre::oslgen {

/// Node group with a script node; form: cpp_tools/doc/manifest.md.
[[nodiscard]] nlohmann::json osl_graph(const Context& context);

/// Node group of Blender's own nodes; null where there is none.
[[nodiscard]] nlohmann::json node_graph(const Context& context);

}  // namespace nacre::oslgen
