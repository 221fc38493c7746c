// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/spectral/rgb_spectrum.h"

namespace nacre::spectral {
namespace {

Vec3 to_rec709(const Vec3& rgb, const ColourSpace& space)
{
    if (!space.chromaticities)
        throw InputError({.file = {},
                          .field = "space",
                          .message = fmt::format("must be an RGB space (got '{}')", space.name)});
    const ColourSpace& rec709 = colour_space("lin_rec709_scene");
    if (space.name == rec709.name) return rgb;  // to the last bit
    return multiply(rec709.from_xyz_d65, multiply(space.to_xyz_d65, rgb));
}

RisenSpectrum reflectance_of(const Vec3& rgb, Upsampling how)
{
    if (how == Upsampling::smits) {
        const Sampled values = smits_spectrum(rgb);
        return {values, round_trip_error(rgb, values), std::nullopt};
    }
    const SigmoidSpectrum found = sigmoid_spectrum(rgb);
    const Sampled values = found.on_grid();
    return {values, round_trip_error(rgb, values), found.by_nanometre()};
}

RisenSpectrum emission_of(const Vec3& rgb, Upsampling how)
{
    const double largest = std::ranges::max(rgb);
    const double room = how == Upsampling::sigmoid ? 2.0 : 1.0;
    const double scale = largest > 0.0 ? room * largest : 1.0;
    RisenSpectrum filter = reflectance_of({rgb[0] / scale, rgb[1] / scale, rgb[2] / scale}, how);
    const Sampled light = cie_illuminant("D65").power;
    const double white = emission_to_xyz(light, ObserverId::cie1931)[1];
    for (std::size_t i = 0; i < kWavelengths; ++i) filter.values[i] *= scale * light[i] / white;
    return filter;
}

}  // namespace

Upsampling upsampling_from_name(std::string_view name)
{
    if (name == "jakob-hanika") return Upsampling::sigmoid;
    if (name == "smits") return Upsampling::smits;
    throw InputError({.file = {},
                      .field = "method",
                      .message = fmt::format("must be jakob-hanika or smits (got '{}')", name)});
}

RisenSpectrum rgb_to_spectrum(const Vec3& rgb, const ColourSpace& space, Upsampling how,
                              SpectrumKind kind)
{
    const Vec3 own = to_rec709(rgb, space);
    try {
        return kind == SpectrumKind::emission ? emission_of(own, how) : reflectance_of(own, how);
    } catch (const InputError& error) {
        Diagnostic problem = error.diagnostics().front();
        if (space.name != "lin_rec709_scene")
            problem.message += fmt::format(", which is {:g}, {:g}, {:g} in {}", rgb[0], rgb[1],
                                           rgb[2], space.name);
        throw InputError(std::move(problem));
    }
}

}  // namespace nacre::spectral
