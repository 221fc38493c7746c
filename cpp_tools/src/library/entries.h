// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/library/entry_kind.h"

/// @file
/// Entries of both libraries: that which comes with Nacre, and the user's beside it.

namespace nacre::spectral {

/// Of both libraries, ascending.
[[nodiscard]] std::vector<std::string> all_keys(EntryKind kind);

/// An entry as it stands now.
struct EntrySource {
    std::string name;  ///< for messages: the key, or the user's file
    std::string text;  ///< of the user's file; empty for what comes with Nacre, which never changes
    bool own = false;

    /// Equal for equal contents only. Sizes and times of files do not tell two contents apart: a
    /// file may be rewritten within one tick of the clock or unpacked with an old time.
    [[nodiscard]] std::string identity() const { return own ? name + '\n' + text : name; }
};

/// @throws InputError for a key that both libraries have, one that none has, and a file that
///         cannot be read.
[[nodiscard]] EntrySource entry_source(EntryKind kind, std::string_view key);

/// Keeps what was loaded; references stay valid, also to what a user's file held before.
template <class Entry>
class LoadedEntries {
public:
    /// @param load  called with the key and the source when its entry is not here
    template <class Load>
    const Entry& get(EntryKind kind, std::string_view key, Load&& load)
    {
        const EntrySource source = entry_source(kind, key);
        std::string identity = source.identity();
        const std::lock_guard lock(mutex_);
        auto found = entries_.find(identity);
        if (found == entries_.end())
            found = entries_.emplace(std::move(identity), load(key, source)).first;
        return found->second;
    }

private:
    std::mutex mutex_;
    std::map<std::string, Entry, std::less<>> entries_;  // nodes stay where they are
};

}  // namespace nacre::spectral
