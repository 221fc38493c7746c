// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/shipped.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "nacre/core/resources.h"
#include "nacre/kinds/read_template.h"
#include "nacre/oslgen/shader_source.h"
#include "shader/hand_written.h"

namespace nacre::kinds {
namespace {

/// Resources by the ids of their materials.
const std::map<std::string, std::string_view, std::less<>>& shipped()
{
    static const auto paths = [] {
        std::map<std::string, std::string_view, std::less<>> result;
        for (const std::string_view path : list_resources("templates/"))
            result.emplace(std::filesystem::path(path).stem().string(), path);
        for (const std::string_view path : list_resources("shaders/")) {
            const auto shader = oslgen::parse_shader(find_resource(path).value(), path);
            if (!shader.told("category").empty()) result.emplace(material_id(shader), path);
        }
        return result;
    }();
    return paths;
}

}  // namespace

std::vector<std::string> shipped_ids()
{
    std::vector<std::string> result;
    for (const auto& [id, path] : shipped()) result.push_back(id);
    return result;
}

std::optional<MaterialTemplate> shipped_template(std::string_view id)
{
    const auto found = shipped().find(id);
    if (found == shipped().end()) return std::nullopt;
    const std::string_view path = found->second;
    return parse_template(find_resource(path).value(),
                          std::filesystem::path(path).filename().string());
}

}  // namespace nacre::kinds
