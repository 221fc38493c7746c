// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nacre::capi {

/// Text whose address stays, each once.
const char* kept(const std::string& text);

}  // namespace nacre::capi
