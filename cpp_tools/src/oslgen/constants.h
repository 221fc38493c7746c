// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nacre::oslgen {

/// Of names.
[[nodiscard]] bool is_word(char c);

/// Whether a header only says what resolved() puts in place.
[[nodiscard]] bool is_resolved(std::string_view header);

/// The text with values in place of the names of nacre_constants.h, and I in place of
/// NACRE_TO_VIEWER: what is compiled here is for Cycles, where that is the direction.
[[nodiscard]] std::string resolved(std::string_view osl);

}  // namespace nacre::oslgen
