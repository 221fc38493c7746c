// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace nacre::spectral {

/// Text without HTML: tags go, `&amp;` and its like become characters, white space at the ends and
/// at the ends of lines goes. A `<` that starts no tag stays.
[[nodiscard]] std::string plain_text(std::string_view html);

}  // namespace nacre::spectral
