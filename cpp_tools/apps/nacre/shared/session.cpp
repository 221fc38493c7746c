// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/session.h"

#include <unistd.h>
#include <cstdio>

#include <fmt/format.h>

namespace nacre::tool {

void Session::error(std::string_view text) const
{
    fmt::print(stderr, "{}: {}\n", command, text);
}

void Session::note(std::string_view text) const
{
    if (!quiet) fmt::print(stderr, "{}: {}\n", command, text);
}

void Session::detail(std::string_view text) const
{
    if (verbose && !quiet) fmt::print(stderr, "{}: {}\n", command, text);
}

Progress::Progress(const Session& session)
    : head_(session.command), on_(!session.quiet && isatty(STDERR_FILENO) != 0)
{}

Progress::~Progress()
{
    if (on_ && shown_ >= 0) fmt::print(stderr, "\r\x1b[K");
}

void Progress::show(double fraction)
{
    const int percent = static_cast<int>(100.0 * fraction);
    if (!on_ || percent == shown_) return;
    shown_ = percent;
    fmt::print(stderr, "\r{}: {} %", head_, percent);
    std::fflush(stderr);
}

}  // namespace nacre::tool
