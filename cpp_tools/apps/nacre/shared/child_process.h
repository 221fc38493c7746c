// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>
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
    /// What it writes to its standard output is chatter, which goes nowhere, or with `chatter` to
    /// standard error. Ours it finds under the number in NACRE_REPORT_FD; `capture` collects
    /// errors.
    bool reports = false;
    bool chatter = false;
};

struct ChildResult {
    int exit_code;       ///< 128 + the signal's number where a signal ended it
    int signal;          ///< which one; 0: it ended by itself
    std::string output;  ///< with `capture`
};

/// Runs a program and waits for its end; signals that reach us meanwhile reach it too.
/// @throws InputError when the program cannot be started
[[nodiscard]] ChildResult run_child(const std::vector<std::string>& command,
                                    const ChildOptions& options);

/// A program that is asked and answers in lines while this lives. It is to end with its input, as
/// it does where we are killed; what it writes to stderr is dropped.
class Dialogue {
public:
    /// @throws InputError when the program cannot be started
    Dialogue(const std::vector<std::string>& command,
             const std::map<std::string, std::string>& environment);
    Dialogue(const Dialogue&) = delete;
    Dialogue& operator=(const Dialogue&) = delete;
    ~Dialogue();

    /// Its next line; nothing once it has ended.
    [[nodiscard]] std::optional<std::string> read_line();
    /// One that has ended shows in the next read_line().
    void write_line(std::string text);

private:
    int input_ = -1, output_ = -1;  ///< of the program
    pid_t child_ = 0;
    std::string unread_;
};

/// A program on PATH, or at the path given when it holds a slash.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name);

}  // namespace nacre::tool
