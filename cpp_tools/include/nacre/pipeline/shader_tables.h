// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nacre::pipeline {

/// Cells of a path's wavelength in every shader. In the green they are below 4 nm wide, finer than
/// a colour can tell.
inline constexpr int kWavelengthCells = 64;

/// Text of `nacre_colour_tables.h`, which gives the hand-written shaders their colours: linear
/// Rec.709, D65, CIE 1931. The shaders of compiled materials carry tables of their own.
[[nodiscard]] std::string colour_tables_header();

}  // namespace nacre::pipeline
