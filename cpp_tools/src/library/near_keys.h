// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre::spectral {

/// The message for a key that is in no library: names those of `keys` that a user may have meant.
[[nodiscard]] std::string unknown_key_message(std::string_view key,
                                              const std::vector<std::string>& keys);

}  // namespace nacre::spectral
