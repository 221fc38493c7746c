// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace nacre::material {

/// The line, from 1, of the first dotted key with more than kMaxKeyParts parts; 0 when there is
/// none. Each part is a table inside the last one, and the parser frees tables by recursion: a key
/// of 100 000 parts would end the process.
[[nodiscard]] int line_of_endless_key(std::string_view toml);

}  // namespace nacre::material
