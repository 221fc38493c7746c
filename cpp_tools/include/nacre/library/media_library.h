// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/media/optical_constants.h"

/// @file
/// Media by key: those that come with Nacre and the user's own.

namespace nacre::spectral {

/// A medium that comes with Nacre or is the user's own, by key; `air` and `vacuum` are n = 1.
/// Thread-safe; the reference stays valid.
/// @throws InputError for an unknown key; the message names near matches.
[[nodiscard]] const Medium& library_medium(std::string_view key);
[[nodiscard]] std::vector<std::string> library_keys();

}  // namespace nacre::spectral
