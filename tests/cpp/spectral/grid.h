// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// Where a wavelength stands among those of every spectrum.
constexpr std::size_t at_nm(int nm)
{
    return static_cast<std::size_t>(nm - kFirstNm);
}

}  // namespace nacre::spectral
