// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

/// @file
/// Files that appear whole, in a process that may be interrupted at any time.

namespace nacre::tool {

/// To `path`, or to the standard output when it is empty or `-`.
/// @throws InputError when the text cannot be written.
void write_text_output(const std::string& path, std::string_view text);

/// Before long work: finds out whether `path` can be written, and leaves everything as it is.
/// @throws InputError as writing would
void check_writable(const std::filesystem::path& path);

}  // namespace nacre::tool
