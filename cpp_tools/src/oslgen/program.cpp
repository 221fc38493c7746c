// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/program.h"

#include <array>
#include <cstddef>

namespace nacre::oslgen {

std::string_view closure_role_name(ClosureRole role)
{
    constexpr std::array<std::string_view, 3> kNames{"surface", "emission", "volume"};
    return kNames.at(static_cast<std::size_t>(role));
}

std::string_view truth_name(Truth truth)
{
    constexpr std::array<std::string_view, 3> kNames{"", "stack", "white"};
    return kNames.at(static_cast<std::size_t>(truth));
}

}  // namespace nacre::oslgen
