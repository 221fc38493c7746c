// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/colour.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

Vec3 xyz_of_chromaticity(double x, double y) noexcept
{
    return {x / y, 1.0, (1.0 - x - y) / y};
}

/// SMPTE RP 177: columns are the primaries, scaled so that (1, 1, 1) is the white.
Mat3 primaries_to_xyz(const std::array<double, 8>& chromaticities) noexcept
{
    Mat3 columns{};
    for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 primary = xyz_of_chromaticity(chromaticities[2 * c], chromaticities[2 * c + 1]);
        for (std::size_t row = 0; row < 3; ++row) columns[row][c] = primary[row];
    }
    const Vec3 white = xyz_of_chromaticity(chromaticities[6], chromaticities[7]);
    return multiply(columns, diagonal(multiply(inverse(columns), white)));
}

ColourSpace rgb_space(std::string name, const std::array<double, 8>& chromaticities)
{
    const Vec3 white = xyz_of_chromaticity(chromaticities[6], chromaticities[7]);
    const Mat3 to_xyz_d65 = multiply(adaptation(Adaptation::bradford, white, d65_white()),
                                     primaries_to_xyz(chromaticities));
    return {.name = std::move(name),
            .from_xyz_d65 = inverse(to_xyz_d65),
            .to_xyz_d65 = to_xyz_d65,
            .chromaticities = chromaticities};
}

const std::vector<ColourSpace>& spaces()
{
    constexpr Mat3 kIdentity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    static const std::vector<ColourSpace> all = {
        // ITU-R BT.709-6, BT.2020-2, SMPTE ST 2065-4 (ACEScg)
        rgb_space("lin_rec709_scene", {0.640, 0.330, 0.300, 0.600, 0.150, 0.060, 0.3127, 0.3290}),
        rgb_space("lin_rec2020_scene", {0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290}),
        rgb_space("lin_ap1_scene", {0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767}),
        {.name = "xyz_d65",
         .from_xyz_d65 = kIdentity,
         .to_xyz_d65 = kIdentity,
         .chromaticities = std::nullopt},
    };
    return all;
}

}  // namespace

Adaptation adaptation_from_name(std::string_view name)
{
    if (name == "bradford") return Adaptation::bradford;
    if (name == "cat16") return Adaptation::cat16;
    if (name == "none") return Adaptation::none;
    throw InputError(
        {.file = {},
         .field = "adaptation",
         .message = fmt::format("must be one of bradford, cat16, none (got '{}')", name)});
}

std::string adaptation_name(Adaptation how)
{
    switch (how) {
        case Adaptation::bradford:
            return "bradford";
        case Adaptation::cat16:
            return "cat16";
        case Adaptation::none:
            break;
    }
    return "none";
}

Mat3 adaptation(Adaptation how, const Vec3& from_white, const Vec3& to_white,
                std::string_view way_out)
{
    if (how == Adaptation::none) return diagonal({1.0, 1.0, 1.0});
    // ICC.1:2022, annex E; Li et al. 2017, Color Research & Application 42, 703.
    constexpr Mat3 kBradford = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    constexpr Mat3 kCat16 = {{{0.401288, 0.650173, -0.051461},
                              {-0.250268, 1.204414, 0.045854},
                              {-0.002079, 0.048952, 0.953127}}};
    const Mat3& cones = how == Adaptation::bradford ? kBradford : kCat16;
    const Vec3 from = multiply(cones, from_white);
    // Of a line of sodium, say: no factor on the cones makes it white.
    if (!(std::ranges::min(from) > 0.0))
        throw InputError(
            {.file = {},
             .field = "illuminant",
             .message = fmt::format("must have a white that can be adapted, cone responses all > 0 "
                                    "(got {}, {}, {}){}",
                                    from[0], from[1], from[2], way_out)});
    const Vec3 to = multiply(cones, to_white);
    const Mat3 scale = diagonal({to[0] / from[0], to[1] / from[1], to[2] / from[2]});
    return multiply(inverse(cones), multiply(scale, cones));
}

Vec3 d65_white() noexcept
{
    return xyz_of_chromaticity(0.3127, 0.3290);
}

const ColourSpace& colour_space(std::string_view name)
{
    const auto found = std::ranges::find(spaces(), name, &ColourSpace::name);
    if (found == spaces().end())
        throw InputError({.file = {},
                          .field = "space",
                          .message = fmt::format("must be one of {} (got '{}')",
                                                 fmt::join(colour_space_names(), ", "), name)});
    return *found;
}

std::vector<std::string> colour_space_names()
{
    std::vector<std::string> names;
    for (const ColourSpace& space : spaces()) names.push_back(space.name);
    return names;
}

}  // namespace nacre::spectral
