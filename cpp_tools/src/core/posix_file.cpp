// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "posix_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "nacre/core/diagnostics.h"

namespace nacre {

FileDescriptor::~FileDescriptor()
{
    if (valid()) ::close(fd_);
}

bool FileDescriptor::close() noexcept
{
    return ::close(std::exchange(fd_, -1)) == 0;
}

void throw_write_error(const std::filesystem::path& shown, int error)
{
    std::string message = "cannot be written: ";
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            message += "no space left on the disc";
            break;
        case EACCES:
        case EPERM:
        case EROFS:
            message += "the folder is not writable";
            break;
        case ENOENT:
        case ENOTDIR:
            message += "there is no such folder";
            break;
        default:
            message += std::strerror(error);
    }
    throw InputError({.file = shown.string(), .field = {}, .message = std::move(message)});
}

void write_and_sync(int fd, std::string_view bytes, const std::filesystem::path& shown)
{
    while (!bytes.empty()) {
        const ::ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw_write_error(shown, errno);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    // EINVAL: a file system without anything to flush.
    if (::fsync(fd) != 0 && errno != EINVAL) throw_write_error(shown, errno);
}

}  // namespace nacre
