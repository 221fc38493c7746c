// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nacre/core/diagnostics.h"
#include "nacre/oslgen/program.h"
#include "nacre/oslgen/shader_source.h"

namespace nacre::kinds {

/// Forms of a hand-written shader that are graphs of nodes, each a comment of its own with the
/// graph as manifests have it: `/* nodes { … } */`, without which OSL is needed, and `/* bands { …
/// } */`, for where bands of wavelengths are rendered.
enum class NodeForm { nodes, bands };

[[nodiscard]] std::optional<nlohmann::json> node_form(NodeForm form,
                                                      const oslgen::ShaderSource& shader,
                                                      std::span<const oslgen::Socket> sockets,
                                                      std::span<const oslgen::Closure> closures,
                                                      DiagnosticList& problems);

/// The shader's text without those comments.
[[nodiscard]] std::string without_node_forms(std::string_view text);

}  // namespace nacre::kinds
