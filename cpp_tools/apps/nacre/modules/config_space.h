// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "nacre/spectral/matrix.h"

/// @file
/// What is asked of OpenColorIO, whichever process it is in.

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

}  // namespace nacre::tool
