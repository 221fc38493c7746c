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

/// A hand-written shader's form in nodes: a comment `/* nodes { … } */` with the graph as manifests
/// have it. Without one, OSL is needed.
[[nodiscard]] std::optional<nlohmann::json> node_form(const oslgen::ShaderSource& shader,
                                                      std::span<const oslgen::Socket> sockets,
                                                      std::span<const oslgen::Closure> closures,
                                                      DiagnosticList& problems);

/// The shader's text without that comment.
[[nodiscard]] std::string without_node_form(std::string_view text);

}  // namespace nacre::kinds
