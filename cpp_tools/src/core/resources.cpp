// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/resources.h"

#include <algorithm>

#include "embedded_files.h"

namespace nacre {

std::optional<std::string_view> find_resource(std::string_view path) noexcept
{
    const auto files = embedded_files();
    const auto found = std::ranges::lower_bound(files, path, {}, &EmbeddedFile::path);
    if (found == files.end() || found->path != path) return std::nullopt;
    return found->content;
}

std::vector<std::string_view> list_resources(std::string_view prefix)
{
    std::vector<std::string_view> paths;
    for (const EmbeddedFile& file : embedded_files())
        if (file.path.starts_with(prefix)) paths.push_back(file.path);
    return paths;
}

}  // namespace nacre
