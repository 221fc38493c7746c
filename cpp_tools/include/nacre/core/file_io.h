// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/core/limits.h"

/// @file
/// Whole files in, whole files out.

namespace nacre {

/// Reads a text file as UTF-8 bytes.
/// @throws InputError when it is missing, unreadable, a folder, or larger than `limit`.
[[nodiscard]] std::string read_text(const std::filesystem::path& path,
                                    std::size_t limit = kMaxTextBytes);

/// Writes `bytes` beside `path`, flushes them to the disc, then renames: a reader sees the old file
/// or the whole new one, and a full disc or a kill leaves the old one untouched. Where the file
/// system can (Linux: O_TMPFILE), a kill leaves nothing else behind either.
/// @throws InputError when the folder is missing or not writable, or the disc is full.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

/// A file written aside by somebody else's library (an image writer) that appears under its own
/// name only on `commit()`; without it the destructor removes the temporary file.
class AtomicFile {
public:
    /// @throws InputError when the folder is missing or not writable.
    explicit AtomicFile(const std::filesystem::path& target);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// Where to write; same folder and same extension as the target.
    [[nodiscard]] const std::filesystem::path& temporary() const noexcept { return temporary_; }
    void commit();

private:
    std::filesystem::path target_, temporary_;
    bool committed_ = false;
};

}  // namespace nacre
