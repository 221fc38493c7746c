// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace nacre {

struct EmbeddedFile {
    std::string_view path, content;
};

/// In ascending order of path. Defined in a source that the build writes.
[[nodiscard]] std::span<const EmbeddedFile> embedded_files() noexcept;

}  // namespace nacre
