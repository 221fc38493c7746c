// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace nacre::tool {

/// A file or folder below `<prefix>`, where `<prefix>/bin` holds this program; the build tree has
/// the same layout. @throws InputError when it is not there
[[nodiscard]] std::filesystem::path installed_path(const std::filesystem::path& name);

/// The same below `<prefix>/share/nacre`.
[[nodiscard]] std::filesystem::path share_path(const std::filesystem::path& name);

}  // namespace nacre::tool
