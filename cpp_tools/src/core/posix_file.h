// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

/// @file
/// File descriptors that close themselves, and errno as a message for the user.

namespace nacre {

/// Owns a file descriptor.
class FileDescriptor {
public:
    explicit FileDescriptor(int fd) noexcept : fd_(fd) {}
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor();

    [[nodiscard]] int get() const noexcept { return fd_; }
    [[nodiscard]] bool valid() const noexcept { return fd_ >= 0; }
    /// Closes now; errno says why where it returns false.
    [[nodiscard]] bool close() noexcept;

private:
    int fd_;
};

/// @throws InputError always: `shown` and what `error`, an errno, means when writing a file.
[[noreturn]] void throw_write_error(const std::filesystem::path& shown, int error);

/// Writes everything and flushes it to the disc.
/// @param shown  the file's name in messages
/// @throws InputError when the disc is full or fails.
void write_and_sync(int fd, std::string_view bytes, const std::filesystem::path& shown);

}  // namespace nacre
