// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/staged_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_io_error(const fs::path& path, int error)
{
    throw InputError(
        {path.string(), 0, "", fmt::format("cannot be written: {}", std::strerror(error))});
}

}  // namespace

StagedFolder::StagedFolder(fs::path target) : target_(std::move(target))
{
    const fs::path parent = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    std::error_code error;
    fs::create_directories(parent, error);
    if (error) throw_io_error(parent, error.value());
    std::string name = (parent / fmt::format(".{}.XXXXXX", target_.filename().string())).string();
    if (!mkdtemp(name.data())) throw_io_error(parent, errno);
    temporary_ = name;
    chmod(name.c_str(), 0755);  // mkdtemp makes private folders
}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {}))
{}

StagedFolder::~StagedFolder()
{
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
}

void StagedFolder::commit()
{
    if (!fs::exists(target_)) {
        if (std::rename(temporary_.c_str(), target_.c_str()) != 0) throw_io_error(target_, errno);
        temporary_.clear();
        return;
    }
    if (renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0)
        return;  // temporary_ is the old folder now; the destructor removes it
    const fs::path old = temporary_.string() + ".old";
    if (std::rename(target_.c_str(), old.c_str()) != 0) throw_io_error(target_, errno);
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
        const int error = errno;
        std::rename(old.c_str(), target_.c_str());
        throw_io_error(target_, error);
    }
    temporary_ = old;
}

}  // namespace nacre::tool
