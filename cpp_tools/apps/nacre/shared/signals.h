// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>
#include <stdexcept>

/// @file
/// SIGINT and SIGTERM leave no temporary files behind.

namespace nacre::tool {

/// Thrown where an interruption may be acted on; `main` turns it into 128 + the signal's number.
class Interrupted : public std::exception {
public:
    explicit Interrupted(int signal) noexcept : signal_(signal) {}
    [[nodiscard]] int exit_code() const noexcept { return 128 + signal_; }
    [[nodiscard]] const char* what() const noexcept override { return "interrupted"; }

private:
    int signal_;
};

/// From here on SIGINT and SIGTERM end the process with exit code 130 or 143: at once while nothing
/// is being written, else at the next `check_interrupted()`, or when the last guard is released.
void install_signal_handlers();

/// @throws Interrupted when a signal has come.
void check_interrupted();
[[nodiscard]] bool interrupted() noexcept;

/// Held while temporary files exist.
class WritingGuard {
public:
    WritingGuard() noexcept;
    WritingGuard(const WritingGuard&) = delete;
    WritingGuard& operator=(const WritingGuard&) = delete;
    ~WritingGuard();
};

/// Signals that were sent to this process alone are passed on to `child` (0: to none); those that
/// come from the terminal reach the whole foreground group by themselves.
void forward_signals_to(pid_t child) noexcept;

}  // namespace nacre::tool
