// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace nacre {

/// Version of the library and the tool, `major.minor.patch`; stated in the root CMakeLists.txt.
[[nodiscard]] std::string_view version() noexcept;

}  // namespace nacre
