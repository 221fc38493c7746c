// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shipped.h"

#include <algorithm>

#include <fmt/format.h>

#include "illuminant_entries.h"
#include "nacre/core/resources.h"

namespace nacre::spectral {

bool is_shipped(EntryKind kind, std::string_view key)
{
    if (kind == EntryKind::medium && (key == "air" || key == "vacuum")) return true;
    if (kind == EntryKind::spectrum && is_illuminant_key(key)) return true;
    return find_resource(fmt::format("{}{}{}", entry_folder(kind), key, entry_extension(kind)))
        .has_value();
}

std::vector<std::string> shipped_keys(EntryKind kind)
{
    std::vector<std::string> keys;
    if (kind == EntryKind::medium) keys = {"air", "vacuum"};
    if (kind == EntryKind::spectrum) keys = illuminant_keys();
    for (std::string_view path : list_resources(entry_folder(kind))) {
        path.remove_prefix(entry_folder(kind).size());
        path.remove_suffix(entry_extension(kind).size());
        keys.emplace_back(path);
    }
    std::ranges::sort(keys);
    return keys;
}

}  // namespace nacre::spectral
