// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

namespace nacre::tool {

struct Session;

/// All commands, in the order of commands.cpp.
void add_commands(CLI::App& app, Session& session);

}  // namespace nacre::tool
