// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "develop/exchange.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/named_spectrum.h"
#include "plot/frame.h"

/// @file
/// What is at some places of a spectral picture.

namespace nacre::tool {

struct Region {
    std::size_t x, y, width, height;  ///< from 0 at the top left
};

/// `X,Y` or `X,Y,W,H`. @throws InputError for what is none, or not within the picture
[[nodiscard]] Region region_from(const std::string& text, const char* option,
                                 const SpectralPicture& picture);

/// In each band, per nm.
[[nodiscard]] std::vector<double> mean_radiance(const SpectralPicture& picture,
                                                const Mixture& mixture, const Region& region);

struct Place {
    std::string text;  ///< as the user wrote it
    Region region;
    std::vector<double> radiance;
    spectral::Vec3 rgb;
};

[[nodiscard]] spectral::NamedSpectrum spectrum_of(const Place& place,
                                                  const SpectralPicture& picture);

/// The first over the visible spectrum, others as lines; `title` is a file. @pre one or more
[[nodiscard]] Plot plot_of_places(const std::vector<spectral::NamedSpectrum>& places,
                                  const std::string& title);

/// As text or JSON. Of two places besides, for each light of `under`, ΔE00 between them, and their
/// special index of metamerism for a change in illuminant (CIE 015:2018): ΔE00 where the second is
/// first multiplied so that both are alike under the light they were rendered with. White is what
/// has a luminance of 1.
/// @throws InputError where `under` is asked of lamps that are not of one light
[[nodiscard]] std::string report(bool as_json, const std::vector<Place>& places,
                                 const SpectralPicture& picture, const Mixture& mixture,
                                 const std::vector<std::string>& under,
                                 const spectral::ColourSpace& space);

}  // namespace nacre::tool
