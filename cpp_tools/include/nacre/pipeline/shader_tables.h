// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nacre::pipeline {

/// Text of `nacre_colour_tables.h`, which gives the hand-written shaders their colours: linear
/// Rec.709, D65, CIE 1931. The shaders of compiled materials carry tables of their own.
[[nodiscard]] std::string colour_tables_header();

}  // namespace nacre::pipeline
