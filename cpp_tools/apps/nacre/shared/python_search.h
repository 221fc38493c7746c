// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Pythons and Blenders that a command may ask.

namespace nacre::tool {

struct FoundProgram {
    std::filesystem::path path;
    std::string origin;  ///< `NACRE_PYTHON`, `python3 on the path`
};

/// Of the environment; empty where it is not set.
[[nodiscard]] std::string environment_variable(const char* name);

/// `.venv` of the checkout and of the prefix, python3 on the path; those that are there.
[[nodiscard]] std::vector<FoundProgram> pythons_at_hand();

/// `blender` on the path.
[[nodiscard]] std::optional<FoundProgram> blender_at_hand();

/// The Python that an unpacked Blender carries with it.
[[nodiscard]] std::optional<std::filesystem::path> python_of_blender(
    const std::filesystem::path& blender);

}  // namespace nacre::tool
