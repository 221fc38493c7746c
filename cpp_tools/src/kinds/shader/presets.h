// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "nacre/core/diagnostics.h"
#include "nacre/oslgen/shader_source.h"
#include "nacre/oslgen/socket.h"

namespace nacre::kinds {

/// A number as it stands in a shader; nothing where it is more than that.
[[nodiscard]] std::optional<double> literal_number(std::string_view text);

/// Takes the text up to the next `separator` away, without blanks around it.
[[nodiscard]] std::string next_item(std::string_view& rest, char separator);

/// `string presets = "Soap film: film_n = 1.33, thickness_nm = 400; Gold: …"` of the metadata:
/// `[{"name": "Soap film", "values": {"film_n": 1.33, …}}, …]`.
[[nodiscard]] nlohmann::json read_presets(const oslgen::ShaderSource& shader,
                                          std::span<const oslgen::Socket> sockets,
                                          DiagnosticList& problems);

}  // namespace nacre::kinds
