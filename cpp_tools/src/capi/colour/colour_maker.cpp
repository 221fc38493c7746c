// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colour/colour_maker.h"

#include <algorithm>

#include "base/guard.h"
#include "nacre/library/lights.h"

namespace nacre::capi {

using spectral::multiply, spectral::Vec3;

spectral::Adaptation adaptation_or_bradford(const char* name)
{
    return name ? spectral::adaptation_from_name(name) : spectral::Adaptation::bradford;
}

ColourMaker::ColourMaker(const nacre_colour_options& options)
    : reflectance_(options.reflectance != 0)
{
    require(options.observer, "observer");
    require(options.space, "space");
    if (reflectance_) require(options.illuminant, "illuminant");
    observer_ = spectral::observer_from_name(options.observer);
    space_ = &spectral::colour_space(options.space);
    gamut_ = options.gamut ? spectral::gamut_mapping_from_name(options.gamut)
                           : spectral::GamutMapping::keep;
    if (gamut_ != spectral::GamutMapping::keep && !space_->chromaticities)
        fail("gamut", "must be keep in a space that is not RGB");
    const auto how = adaptation_or_bradford(options.adaptation);
    if (reflectance_) {
        set_light(spectral::named_illuminant(options.illuminant), how);
    } else {
        white_ = spectral::emission_white(observer_);
        to_d65_ = spectral::emission_to_d65(observer_);
    }
}

nacre_colour ColourMaker::operator()(const spectral::Sampled& values) const
{
    return from_xyz(reflectance_ ? reflectance_to_xyz(values, light_, observer_)
                                 : spectral::emission_to_xyz(values, observer_));
}

nacre_colour ColourMaker::from_xyz(const Vec3& xyz) const
{
    const Vec3 lab = spectral::xyz_to_lab(xyz, white_);
    const Vec3 rgb = map_to_gamut(
        multiply(space_->from_xyz_d65, multiply(to_d65_, xyz)), gamut_, space_->to_xyz_d65[1],
        reflectance_ ? spectral::ColourOf::surface : spectral::ColourOf::light);
    nacre_colour colour{};
    std::copy(xyz.begin(), xyz.end(), colour.XYZ);
    std::copy(lab.begin(), lab.end(), colour.Lab);
    std::copy(rgb.begin(), rgb.end(), colour.rgb);
    return colour;
}

void ColourMaker::set_light(spectral::Illuminant light, spectral::Adaptation how)
{
    light_ = std::move(light);
    white_ = white_under(light_, observer_);
    to_d65_ = spectral::adaptation(how, white_, spectral::d65_white(),
                                   "; adaptation 'none' takes it as it is");
}

}  // namespace nacre::capi
