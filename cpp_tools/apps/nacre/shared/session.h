// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

/// @file
/// What all commands share: global options, exit codes, the way errors and progress are shown.

namespace nacre::tool {

inline constexpr int kExitOk = 0;
inline constexpr int kExitInputError = 1;   ///< usage or input
inline constexpr int kExitCheckFailed = 2;  ///< a comparison above its limit

/// Global options, and what the chosen command is to do once the command line is whole.
struct Session {
    bool verbose = false;
    bool quiet = false;
    bool json = false;
    int threads = 0;                ///< 0: one a core
    std::string command = "nacre";  ///< `nacre bake`, the head of every message
    std::function<int()> run;

    /// Prints `nacre bake: text` to stderr.
    void error(std::string_view text) const;
    /// The same for information, not with --quiet.
    void note(std::string_view text) const;
    /// The same, only with -v.
    void detail(std::string_view text) const;
};

/// Shows `nacre bake: 42 %` on a terminal, nothing in a pipe or with --quiet.
class Progress {
public:
    explicit Progress(const Session& session);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();
    /// @param fraction  of the work that is done, 0 … 1
    void show(double fraction);

private:
    std::string head_;
    bool on_;
    int shown_ = -1;
};

}  // namespace nacre::tool
