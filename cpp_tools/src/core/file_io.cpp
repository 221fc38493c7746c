// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include "nacre/core/diagnostics.h"
#include "posix_file.h"

namespace nacre {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void throw_read_error(const fs::path& path, std::string message)
{
    throw InputError({.file = path.string(), .field = {}, .message = std::move(message)});
}

/// `scheme://` at the start (RFC 3986, 3.1).
bool is_uri(std::string_view text)
{
    const std::size_t length = std::min(text.find("://"), text.size());
    const auto in_scheme = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '+' || c == '-' || c == '.';
    };
    return length > 1 && length < text.size() &&
           std::ranges::all_of(text.substr(0, length), in_scheme);
}

[[noreturn]] void throw_open_error(const fs::path& path, int error)
{
    if (error == ENOENT && is_uri(path.native()))
        throw_read_error(path,
                         "must be a file; this is a URI, whose content has to be saved first");
    throw_read_error(path, error == ENOENT
                               ? std::string("there is no such file")
                               : std::string("cannot be read: ") + std::strerror(error));
}

fs::path folder_of(const fs::path& file)
{
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// The file that a link stands for. Devices and folders are refused: a rename would replace them.
fs::path checked_target(const fs::path& path)
{
    std::error_code error;
    fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
    const fs::file_status status = fs::status(target, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw_read_error(path, fs::is_directory(status) ? "cannot be written: it is a folder"
                                                        : "cannot be written: not a regular file");
    return target;
}

/// A name in the target's folder that no other process and no other call uses.
fs::path name_aside(const fs::path& target)
{
    static std::atomic<unsigned> counter{0};
    const std::string unique =
        std::to_string(::getpid()) + "-" + std::to_string(counter.fetch_add(1));
    return folder_of(target) /
           ("." + target.stem().string() + "." + unique + ".partial" + target.extension().string());
}

int create_new(const fs::path& path)
{
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

void sync_folder(const fs::path& folder)
{
    const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // Best effort: the rename is done, and some file systems cannot flush a folder.
    if (directory.valid()) (void)::fsync(directory.get());
}

/// A file in `folder` without a name, which the system takes away with its writer; not every file
/// system has them.
int create_nameless(const fs::path& folder)
{
#ifdef O_TMPFILE
    return ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
#else
    (void)folder;
    return -1;
#endif
}

void rename_over(const fs::path& from, const fs::path& to)
{
    if (::rename(from.c_str(), to.c_str()) != 0) {
        const int error = errno;
        (void)::unlink(from.c_str());
        throw_write_error(to, error);
    }
    sync_folder(folder_of(to));
}

/// Leaves nothing behind, not even when the process is killed while it writes.
/// @returns false when the file system cannot do so; nothing is written then.
bool write_through_nameless_file(const fs::path& path, std::string_view bytes)
{
    const fs::path target = checked_target(path);
    const FileDescriptor file(create_nameless(folder_of(target)));
    if (!file.valid()) return false;
    write_and_sync(file.get(), bytes, path);

    // A link cannot replace a file, a rename can: so the file gets a name of its own first.
    const fs::path aside = name_aside(target);
    const std::string handle = "/proc/self/fd/" + std::to_string(file.get());
    if (::linkat(AT_FDCWD, handle.c_str(), AT_FDCWD, aside.c_str(), AT_SYMLINK_FOLLOW) != 0)
        return false;
    rename_over(aside, target);
    return true;
}

}  // namespace

std::string read_text(const fs::path& path, std::size_t limit)
{
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.valid()) throw_open_error(path, errno);
    struct stat status {};
    if (::fstat(file.get(), &status) == 0 && S_ISDIR(status.st_mode))
        throw_read_error(path, "cannot be read: it is a folder");

    // The size is counted while reading: pipes and /proc state none.
    std::string text;
    for (;;) {
        constexpr std::size_t kStep = std::size_t{1} << 16;
        const std::size_t before = text.size();
        text.resize(before + kStep);
        const ::ssize_t got = ::read(file.get(), text.data() + before, kStep);
        text.resize(before + (got > 0 ? static_cast<std::size_t>(got) : 0));
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw_read_error(path, std::string("cannot be read: ") + std::strerror(errno));
        if (got == 0) return text;
        if (text.size() > limit)
            throw_read_error(path, "must not be larger than " + std::to_string(limit) + " bytes");
    }
}

void write_atomically(const fs::path& path, std::string_view bytes)
{
    if (write_through_nameless_file(path, bytes)) return;
    AtomicFile file(path);
    FileDescriptor out(::open(file.temporary().c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!out.valid()) throw_write_error(path, errno);
    write_and_sync(out.get(), bytes, path);
    if (!out.close()) throw_write_error(path, errno);
    file.commit();
}

AtomicFile::AtomicFile(const fs::path& target) : target_(checked_target(target))
{
    // Created now, so that an unwritable folder is found before hours of work and not after.
    int fd = -1;
    do {
        temporary_ = name_aside(target_);
        fd = create_new(temporary_);
    } while (fd < 0 && errno == EEXIST);
    if (fd < 0) throw_write_error(target, errno);
    (void)FileDescriptor(fd).close();
}

AtomicFile::~AtomicFile()
{
    if (!committed_) (void)::unlink(temporary_.c_str());
}

void AtomicFile::commit()
{
    // Whoever wrote the file has closed it, but perhaps not flushed it.
    FileDescriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.valid()) throw_write_error(target_, errno);
    write_and_sync(file.get(), {}, target_);
    rename_over(temporary_, target_);
    committed_ = true;
}

}  // namespace nacre
