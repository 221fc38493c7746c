// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "guard.h"
#include "nacre/optics/grating.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::capi {
namespace {

using spectral::Vec3;

Vec3 multiply(const spectral::Mat3& matrix, const Vec3& vector)
{
    Vec3 product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            product[row] += matrix[row][column] * vector[column];
    return product;
}

struct Colour {
    Vec3 xyz, xyz_d65, white;
};

Colour reflectance_colour(const spectral::Sampled& values, const char* illuminant,
                          spectral::ObserverId observer)
{
    const spectral::Illuminant light = spectral::named_illuminant(illuminant);
    spectral::Sampled perfect;
    perfect.fill(1.0);
    const Vec3 white = reflectance_to_xyz(perfect, light, observer);
    const Vec3 xyz = reflectance_to_xyz(values, light, observer);
    return {
        xyz,
        multiply(spectral::adaptation(spectral::Adaptation::bradford, white, spectral::d65_white()),
                 xyz),
        white};
}

optics::ProfileKind profile_kind(std::string_view name)
{
    if (name == "sinusoidal") return optics::ProfileKind::sinusoidal;
    if (name == "rectangular") return optics::ProfileKind::rectangular;
    if (name == "blazed") return optics::ProfileKind::blazed;
    fail("profile.kind", fmt::format("must be sinusoidal, rectangular or blazed (got {})", name));
}

optics::Direction direction(const double (&values)[3])
{
    return {values[0], values[1], values[2]};
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_spectrum_to_colour(size_t count, const double* wavelength_nm,
                                      const double* values, int reflectance, const char* illuminant,
                                      const char* observer, const char* space, nacre_colour* colour)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(wavelength_nm, "wavelength_nm");
        capi::require(values, "values");
        capi::require(observer, "observer");
        capi::require(space, "space");
        capi::require(colour, "colour");
        if (reflectance != 0) capi::require(illuminant, "illuminant");

        const auto& target = spectral::colour_space(space);
        const auto id = spectral::observer_from_name(observer);
        const auto sampled = spectral::Spectrum(std::vector(wavelength_nm, wavelength_nm + count),
                                                std::vector(values, values + count))
                                 .on_grid();
        capi::Colour result{};
        if (reflectance != 0) {
            result = capi::reflectance_colour(sampled, illuminant, id);
        } else {
            result.xyz = result.xyz_d65 = spectral::emission_to_xyz(sampled, id);
            result.white = spectral::d65_white();
        }
        const auto lab = spectral::xyz_to_lab(result.xyz, result.white);
        const auto rgb = capi::multiply(target.from_xyz_d65, result.xyz_d65);
        std::copy(result.xyz.begin(), result.xyz.end(), colour->XYZ);
        std::copy(lab.begin(), lab.end(), colour->Lab);
        std::copy(rgb.begin(), rgb.end(), colour->rgb);
    });
}

nacre_status nacre_grating_orders(const nacre_grating* grating, int first, int last,
                                  double* directions, double* efficiencies)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(grating, "grating");
        capi::require(grating->profile, "profile.kind");
        capi::require(directions, "directions");
        capi::require(efficiencies, "efficiencies");
        const optics::Grating asked{.pitch_nm = grating->pitch_nm,
                                    .grating_vector = capi::direction(grating->grating_vector),
                                    .normal = capi::direction(grating->normal),
                                    .profile = {.kind = capi::profile_kind(grating->profile),
                                                .phase_rad = grating->phase_rad,
                                                .duty = grating->duty}};
        const auto orders = optics::grating_orders(asked, capi::direction(grating->k_in),
                                                   grating->wavelength_nm, first, last);
        for (const optics::DiffractedOrder& order : orders) {
            const auto none = optics::Direction{0.0, 0.0, 0.0};
            const auto out = order.direction.value_or(none);
            directions = std::copy(out.begin(), out.end(), directions);
            *efficiencies++ = order.efficiency;
        }
    });
}
}
