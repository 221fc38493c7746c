// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "base/path_wavelengths.h"

#include <fmt/format.h>

#include "nacre/oslgen/literals.h"

namespace nacre::kinds {

spectral::WavelengthSampling path_wavelengths(const spectral::ColourWeights& weights)
{
    return spectral::sample_wavelengths(weights, spectral::kWavelengthCells);
}

std::vector<oslgen::Constant> wavelength_constants(const spectral::WavelengthSampling& sampling)
{
    return {{.declaration = fmt::format("float wavelength_edges[{}]", sampling.edges_nm.size()),
             .value = oslgen::array_literal(sampling.edges_nm),
             .label = "Wavelength Edges",
             .help = "Inverse CDF of the path's wavelength, nm"},
            {.declaration = fmt::format("color wavelength_weight[{}]", sampling.weight.size()),
             .value = oslgen::array_literal(sampling.weight),
             .label = "Wavelength Weight",
             .help = "Colour that a path of each cell carries"}};
}

}  // namespace nacre::kinds
