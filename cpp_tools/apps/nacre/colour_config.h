// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nacre/spectral/colour.h"

/// @file
/// OpenColorIO configs, read by the OpenColorIO that the tool links to or, where a config is newer
/// than that, by the one of a Python or a Blender at hand.

namespace nacre::tool {

/// Through this role all configs agree on what XYZ is.
inline constexpr const char* kInterchangeRole = "cie_xyz_d65_interchange";

/// What a config has to say about one of its spaces.
struct ConfigSpace {
    std::vector<std::string> names;  ///< of all spaces and roles
    bool is_known = false;           ///< by name, alias or role
    bool is_data = false;
    bool has_interchange = false;  ///< kInterchangeRole
    std::string failure;           ///< why there is no conversion, where all is well up to there
    std::function<spectral::Vec3(const spectral::Vec3& xyz_d65)> from_xyz_d65;
};

/// @param config  a config.ocio, an archive .ocioz, or the URI of a config that OpenColorIO has
/// inside
/// @throws InputError for a config that cannot be read; it says which OpenColorIO that takes
[[nodiscard]] ConfigSpace read_config_space(const std::string& config, const std::string& space);

}  // namespace nacre::tool
