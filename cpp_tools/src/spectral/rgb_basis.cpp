// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/rgb_basis.h"

#include "csv_table.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::spectral {

const std::array<Sampled, 3>& rgb_basis()
{
    static const std::array<Sampled, 3> basis = [] {
        const CsvTable table = load_csv("cmf/rgb_basis_rec709.csv", 4);
        std::array<Sampled, 3> made{};
        for (std::size_t c = 0; c < 3; ++c)
            made[c] =
                Spectrum(table.columns[0], table.columns[c + 1]).on_grid(Interpolation::linear);
        return made;
    }();
    return basis;
}

}  // namespace nacre::spectral
