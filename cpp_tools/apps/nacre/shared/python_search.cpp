// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/python_search.h"

#include <algorithm>
#include <cstdlib>

#include "shared/child_process.h"
#include "shared/share_files.h"

namespace nacre::tool {

namespace fs = std::filesystem;

std::string environment_variable(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::vector<FoundProgram> pythons_at_hand()
{
    std::vector<FoundProgram> found;
    // In a build tree share/nacre/addon is a link into the checkout.
    const fs::path share = share_path("addon");
    for (const fs::path& home :
         {fs::canonical(share).parent_path(), share.parent_path().parent_path().parent_path()})
        if (const auto python = find_program((home / ".venv" / "bin" / "python").string()))
            found.push_back({*python, "environment of " + home.string()});
    if (const auto python = find_program("python3"))
        found.push_back({*python, "python3 on the path"});
    return found;
}

std::optional<FoundProgram> blender_at_hand()
{
    const auto blender = find_program("blender");
    return blender ? std::optional(FoundProgram{*blender, "on the path"}) : std::nullopt;
}

std::optional<fs::path> python_of_blender(const fs::path& blender)
{
    // <folder>/blender, <folder>/5.2/python/bin/python3.13
    std::error_code unreadable;
    std::vector<fs::path> pythons;
    for (const auto& version : fs::directory_iterator(
             fs::weakly_canonical(blender, unreadable).parent_path(), unreadable))
        for (const auto& file :
             fs::directory_iterator(version.path() / "python" / "bin", unreadable))
            if (file.path().filename().string().starts_with("python3") &&
                find_program(file.path().string()))
                pythons.push_back(file.path());
    const auto newest = std::ranges::max_element(pythons);
    return newest == pythons.end() ? std::nullopt : std::optional(*newest);
}

}  // namespace nacre::tool
