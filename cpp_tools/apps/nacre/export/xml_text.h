// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <pugixml.hpp>

/// @file
/// XML documents as they are written: UTF-8, indented by two spaces.

namespace nacre::tool {

[[nodiscard]] std::string xml_text(const pugi::xml_document& document);

}  // namespace nacre::tool
