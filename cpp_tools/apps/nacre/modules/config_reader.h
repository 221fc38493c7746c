// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modules/config_space.h"

/// @file
/// What the module `ocio` gives: the OpenColorIO that the tool is built with.

namespace nacre::tool {

struct ConfigReader {
    static constexpr const char* kModule = "ocio";
    static constexpr const char* kLibrary =
        "OpenColorIO (Debian and Ubuntu: apt-get install opencolorio-tools)";

    std::string (*version)();
    /// @throws std::runtime_error with what is wrong with the config, in one line
    ConfigSpace (*read)(const std::string& config, const std::string& space);
};

}  // namespace nacre::tool
