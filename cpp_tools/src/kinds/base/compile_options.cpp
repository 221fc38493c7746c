// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/compile_options.h"

#include "nacre/library/lights.h"

namespace nacre::kinds {

spectral::ColourWeights CompileOptions::weights() const
{
    const spectral::ColourSpace& target =
        custom_space ? *custom_space : spectral::colour_space(space);
    return spectral::reflectance_weights(spectral::named_illuminant(illuminant), observer, target,
                                         adaptation);
}

}  // namespace nacre::kinds
