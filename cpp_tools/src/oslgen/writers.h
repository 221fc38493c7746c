// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "nacre/oslgen/program.h"

namespace nacre::oslgen {

/// The shader with its `#include` lines still in it.
[[nodiscard]] std::string shader_text(const Program& program);

/// Node group with a script node; form: cpp_tools/doc/manifest.md.
[[nodiscard]] nlohmann::json osl_graph(const Program& program);

/// Node group of Blender's own nodes; null where there is none.
[[nodiscard]] nlohmann::json node_graph(const Program& program);

/// Node group where bands of wavelengths are rendered; null where one of the others will do.
[[nodiscard]] nlohmann::json band_graph(const Program& program);

/// Metadata of a parameter.
[[nodiscard]] std::string metadata(std::string_view label, std::string_view help,
                                   std::string_view more = "");
inline constexpr std::string_view kHidden = ", string widget = \"null\"";

// A surface of tables as OSL: `#include` lines; parameters that carry its colours, looked up
// outside or from a table that is named; statements.
[[nodiscard]] std::string surface_includes(const TableSurface& surface);
[[nodiscard]] std::string surface_parameters(const TableSurface& surface);
[[nodiscard]] std::string surface_statements(const TableSurface& surface);

// And as nodes: whole, and what a script node is given.
[[nodiscard]] nlohmann::json surface_nodes(const TableSurface& surface);
void add_looked_up(Graph& graph, const TableSurface& surface);

}  // namespace nacre::oslgen
