// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/library/entry_kind.h"

/// @file
/// A user's own library beside the one that comes with Nacre: the same files in the same folders.
/// No key is in both; one that is in both is refused by whoever looks it up.

namespace nacre::spectral {

/// $XDG_DATA_HOME/nacre, or ~/.local/share/nacre; empty where neither variable is an absolute path
/// (XDG Base Directory Specification 0.8).
[[nodiscard]] std::filesystem::path user_library_folder();

/// Up to four names between slashes, of ASCII letters, digits and `. _ + -`, none of which starts
/// with a dot; at most kMaxKeyBytes.
[[nodiscard]] bool is_library_key(std::string_view key) noexcept;

/// Keys for which there is a file, ascending; no more than kMaxUserEntries.
[[nodiscard]] std::vector<std::string> user_library_keys(EntryKind kind);

/// The file of a key where there is one; nothing for a text that is no key.
[[nodiscard]] std::optional<std::filesystem::path> user_library_file(EntryKind kind,
                                                                     std::string_view key);

/// Something to be written to the user's library.
struct UserEntry {
    EntryKind kind;
    std::string key;
    std::string text;  ///< of the file
};

/// Writes all entries or, when one cannot be, none.
/// @param replace  whether entries that the user has already are replaced
/// @return the files
/// @throws InputError for a text that is no key, a key of the library that comes with Nacre, one
///         that comes twice or exists already, a text that the library could not read, and
///         for a folder that cannot be written.
std::vector<std::filesystem::path> save_user_entries(const std::vector<UserEntry>& entries,
                                                     bool replace);

}  // namespace nacre::spectral
