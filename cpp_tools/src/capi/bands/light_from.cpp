// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "bands/light_from.h"

#include <string>
#include <vector>

#include "base/guard.h"
#include "nacre/spectral/named_spectrum.h"

namespace nacre::capi {
namespace {

bands::Fine power_of(const nacre_light& given)
{
    if (given.count == 0) return {};
    const spectral::Spectrum samples =
        samples_of(given.count, given.wavelength_nm, given.power, "power");
    if (auto problem = spectral::kind_problem(samples, spectral::SpectrumKind::emission))
        fail("power", *problem);
    return samples.values_at(bands::fine_grid(), spectral::Interpolation::linear);
}

}  // namespace

spectral::Spectrum samples_of(std::size_t count, const double* wavelength_nm, const double* values,
                              const char* field)
{
    require(wavelength_nm, "wavelength_nm");
    require(values, field);
    return {std::vector(wavelength_nm, wavelength_nm + count), std::vector(values, values + count)};
}

bands::Light light_from(const nacre_light& given)
{
    if (given.count == 0 && given.lines == 0) {
        require(given.name, "name");
        return bands::named_light(given.name);
    }
    bands::Light light{.name = text_or_empty(given.name), .power = power_of(given), .lines = {}};
    if (given.lines > 0) {
        require(given.line_nm, "line_nm");
        require(given.line_power, "line_power");
    }
    for (std::size_t i = 0; i < given.lines; ++i)
        light.lines.push_back({.wavelength_nm = given.line_nm[i], .power = given.line_power[i]});
    if (!light.lines.empty()) (void)spectral::line_samples(light.lines);  // refuses bad ones
    return light;
}

}  // namespace nacre::capi
