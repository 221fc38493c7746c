// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/share_files.h"

#include "nacre/core/diagnostics.h"

namespace nacre::tool {

std::filesystem::path installed_path(const std::filesystem::path& name)
{
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    auto path = program.parent_path().parent_path() / name;
    if (!std::filesystem::exists(path))
        throw InputError({path.string(), 0, "", "is missing: the installation is not complete"});
    return path;
}

std::filesystem::path share_path(const std::filesystem::path& name)
{
    return installed_path("share/nacre" / name);
}

}  // namespace nacre::tool
