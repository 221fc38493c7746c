// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/user_library.h"

/// @file
/// The library that comes with Nacre, and the user's beside it.

namespace nacre::spectral {

/// `optical_constants/` or `spectra/`, and `.yml` or `.csv`.
[[nodiscard]] std::string_view shipped_folder(EntryKind kind) noexcept;
[[nodiscard]] std::string_view shipped_extension(EntryKind kind) noexcept;

[[nodiscard]] bool is_shipped(EntryKind kind, std::string_view key);
[[nodiscard]] std::vector<std::string> shipped_keys(EntryKind kind);

/// Of both libraries, ascending.
[[nodiscard]] std::vector<std::string> all_keys(EntryKind kind);

/// What identifies an entry: the key alone, or the user's file and when it was written, so that a
/// file that changes is read again.
/// @throws InputError for a key that both libraries have, and for one that none has.
[[nodiscard]] std::string entry_identity(EntryKind kind, std::string_view key);

/// Keeps what was loaded; references stay valid, also to what a user's file held before.
template <class Entry>
class LoadedEntries {
public:
    /// @param load  called with the key when its entry is not here
    template <class Load>
    const Entry& get(EntryKind kind, std::string_view key, Load&& load)
    {
        std::string identity = entry_identity(kind, key);
        const std::lock_guard lock(mutex_);
        auto found = entries_.find(identity);
        if (found == entries_.end()) found = entries_.emplace(std::move(identity), load(key)).first;
        return found->second;
    }

private:
    std::mutex mutex_;
    std::map<std::string, Entry, std::less<>> entries_;  // nodes stay where they are
};

}  // namespace nacre::spectral
