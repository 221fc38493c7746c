// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace nacre::test {

/// A data folder of a user, empty at first, as long as this object lives.
class OwnLibrary {
public:
    OwnLibrary()
    {
        static int count = 0;
        folder_ = std::filesystem::temp_directory_path() /
                  ("nacre_own_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
        const char* const before = std::getenv("XDG_DATA_HOME");
        if (before != nullptr) before_ = before;
        ::setenv("XDG_DATA_HOME", folder_.c_str(), 1);
    }
    OwnLibrary(const OwnLibrary&) = delete;
    OwnLibrary& operator=(const OwnLibrary&) = delete;
    ~OwnLibrary()
    {
        if (before_.empty())
            ::unsetenv("XDG_DATA_HOME");
        else
            ::setenv("XDG_DATA_HOME", before_.c_str(), 1);
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] std::filesystem::path folder() const { return folder_ / "nacre"; }

private:
    std::filesystem::path folder_;
    std::string before_;
};

}  // namespace nacre::test
