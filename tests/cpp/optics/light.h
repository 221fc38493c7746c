// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>

#include "nacre/optics/multilayer.h"

namespace nacre::optics {

inline constexpr double kNm = 550.0;         ///< a wavelength where any will do
inline constexpr Complex kGold{0.47, 2.41};  ///< about at 550 nm
inline constexpr std::initializer_list<Polarisation> kBoth = {Polarisation::s, Polarisation::p};

}  // namespace nacre::optics
