// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session.h"

/// @file
/// The parts of `nacre library`, one file each.

namespace nacre::tool {

void add_library_define(CLI::App& library, Session& session);
void add_library_import(CLI::App& library, Session& session);
void add_library_list(CLI::App& library, Session& session);
void add_library_show(CLI::App& library, Session& session);

}  // namespace nacre::tool
