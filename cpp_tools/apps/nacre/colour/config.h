// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "modules/config_space.h"

/// @file
/// OpenColorIO configs, read by the OpenColorIO that the tool links to or, where a config is newer
/// than that, by the one of a Python or a Blender at hand.

namespace nacre::tool {

/// @param config  a config.ocio, an archive .ocioz, or the URI of a config that OpenColorIO has
/// inside
/// @throws InputError for a config that cannot be read; it says which OpenColorIO that takes
[[nodiscard]] ConfigSpace read_config_space(const std::string& config, const std::string& space);

}  // namespace nacre::tool
