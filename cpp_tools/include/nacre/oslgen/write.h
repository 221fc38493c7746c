// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "nacre/oslgen/program.h"

/// @file
/// The texts that are made of a program: shader and manifest.

namespace nacre::oslgen {

struct ProgramText {
    std::string osl;       ///< one file, includes inlined
    std::string manifest;  ///< JSON, ends with a newline; form: cpp_tools/doc/manifest.md
};

[[nodiscard]] ProgramText write(const Program& program);

/// Replaces `#include "nacre/…"` by the embedded header's text, each header once.
/// @throws InputError for a header that is not there.
[[nodiscard]] std::string inline_includes(const std::string& osl, const std::string& name);

}  // namespace nacre::oslgen
