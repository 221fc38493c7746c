// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/library/entry_kind.h"

/// @file
/// The library that comes with Nacre.

namespace nacre::spectral {

[[nodiscard]] bool is_shipped(EntryKind kind, std::string_view key);
[[nodiscard]] std::vector<std::string> shipped_keys(EntryKind kind);

}  // namespace nacre::spectral
