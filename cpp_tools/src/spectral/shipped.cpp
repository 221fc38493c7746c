// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shipped.h"

#include <fmt/format.h>

#include <algorithm>

#include "illuminant_table.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/core/resources.h"
#include "near_keys.h"

namespace nacre::spectral {

std::string_view shipped_folder(EntryKind kind) noexcept
{
    return kind == EntryKind::medium ? "optical_constants/" : "spectra/";
}

std::string_view shipped_extension(EntryKind kind) noexcept
{
    return kind == EntryKind::medium ? ".yml" : ".csv";
}

bool is_shipped(EntryKind kind, std::string_view key)
{
    if (kind == EntryKind::medium && (key == "air" || key == "vacuum")) return true;
    if (kind == EntryKind::spectrum && is_illuminant_key(key)) return true;
    return find_resource(fmt::format("{}{}{}", shipped_folder(kind), key, shipped_extension(kind)))
        .has_value();
}

std::vector<std::string> shipped_keys(EntryKind kind)
{
    std::vector<std::string> keys;
    if (kind == EntryKind::medium) keys = {"air", "vacuum"};
    if (kind == EntryKind::spectrum) keys = illuminant_keys();
    for (std::string_view path : list_resources(shipped_folder(kind))) {
        path.remove_prefix(shipped_folder(kind).size());
        path.remove_suffix(shipped_extension(kind).size());
        keys.emplace_back(path);
    }
    std::ranges::sort(keys);
    return keys;
}

std::vector<std::string> all_keys(EntryKind kind)
{
    std::vector<std::string> keys = shipped_keys(kind);
    const std::vector<std::string> own = user_library_keys(kind);
    keys.insert(keys.end(), own.begin(), own.end());
    std::ranges::sort(keys);
    // A key that both have is listed once; who looks it up is told.
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

EntrySource entry_source(EntryKind kind, std::string_view key)
{
    const bool shipped = is_shipped(kind, key);
    const auto own = user_library_file(kind, key);
    if (own && shipped)
        throw InputError({.file = own->string(),
                          .field = {},
                          .message = fmt::format("has the key of an entry that comes with Nacre; "
                                                 "rename or remove the file (got '{}')",
                                                 key)});
    if (shipped) return {.name = std::string(key), .text = {}};
    if (!own)
        throw InputError({.file = {},
                          .field = kind == EntryKind::medium ? "medium" : "spectrum",
                          .message = unknown_key_message(key, all_keys(kind))});
    return {.name = own->string(), .text = read_text(*own), .own = true};
}

}  // namespace nacre::spectral
