// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "nacre/library/media_library.h"
#include "nacre/optics/multilayer.h"
#include "nacre/spectral/colour.h"

// A quarter-wave film of fused silica on an index of 2 reflects ((2 − n²)/(2 + n²))² at normal
// incidence (Born & Wolf 1999, section 1.6.4); the library's data must be inside the binary.
int main()
{
    constexpr double wavelength_nm = 550.0, substrate = 2.0;
    const double n =
        nacre::spectral::library_medium("SiO2/Malitson").constants->at(wavelength_nm).real();
    const nacre::optics::FilmStack stack{
        .ambient = 1.0,
        .layers = {{.n = n, .thickness_nm = wavelength_nm / 4 / n}},
        .substrate = substrate};
    const auto power = nacre::optics::stack_power_unpolarised(stack, 1.0, wavelength_nm);

    const double amplitude = (substrate - n * n) / (substrate + n * n);
    const double error = std::abs(power.R - amplitude * amplitude);
    std::printf("n %.6f  R %.12f  error %.1e  space %s\n", n, power.R, error,
                nacre::spectral::colour_space("lin_ap1_scene").name.c_str());
    return n > 1.45 && n < 1.47 && error < 1e-14 ? 0 : 1;
}
