// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include "base/guard.h"
#include "nacre/spectral/named_spectrum.h"

namespace nacre::capi {

/// @throws InputError for another name
inline spectral::SpectrumKind kind_from(const char* name)
{
    using spectral::SpectrumKind;
    const std::string kind = text_or_empty(name);
    for (const SpectrumKind known : {SpectrumKind::emission, SpectrumKind::reflectance})
        if (kind == spectral::spectrum_kind_name(known)) return known;
    fail("kind", fmt::format("must be emission or reflectance (got \"{}\")", kind));
}

}  // namespace nacre::capi
