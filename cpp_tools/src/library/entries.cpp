// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "entries.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/library/user_library.h"
#include "near_keys.h"
#include "shipped.h"

namespace nacre::spectral {

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
