// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

/// @file
/// A glTF 2.0 document around materials: each on a sphere of its own, in a row.

namespace nacre::tool {

using nlohmann::ordered_json;

enum class GltfContainer { text, binary };  ///< .gltf with its buffer as a data URI; .glb

/// @param materials      glTF materials; one that refers to texture 0 means `thickness_png`
/// @param thickness_png  bytes of an image; empty: no texture
[[nodiscard]] std::string gltf_document(const ordered_json& materials,
                                        const std::string& thickness_png, GltfContainer container);

}  // namespace nacre::tool
