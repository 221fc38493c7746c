// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// @file
/// Programs that a command starts: a shader compiler, Blender, a Python.

namespace nacre::tool {

struct ChildOptions {
    std::filesystem::path folder;                    ///< to run in; empty: the current one
    std::map<std::string, std::string> environment;  ///< set on top of our own
    bool capture = false;  ///< collect stdout and stderr instead of passing them through
};

struct ChildResult {
    int exit_code;       ///< 128 + the signal's number where a signal ended it
    std::string output;  ///< with `capture`
};

/// Runs a program and waits for its end; signals that reach us meanwhile reach it too.
/// @throws InputError when the program cannot be started
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& command,
                                    const ChildOptions& options);

/// A program on PATH, or at the path given when it holds a slash.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace nacre::tool
