// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/gamut.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

Vec3 clipped(const Vec3& rgb, double high) noexcept
{
    return {std::clamp(rgb[0], 0.0, high), std::clamp(rgb[1], 0.0, high),
            std::clamp(rgb[2], 0.0, high)};
}

/// @param high  the brightest that a channel may be
Vec3 desaturated(const Vec3& rgb, const Vec3& luminance, double high) noexcept
{
    const double y = luminance[0] * rgb[0] + luminance[1] * rgb[1] + luminance[2] * rgb[2];
    if (!(y > 0.0)) return {};
    if (y >= high) return {high, high, high};
    // Part of the way from the grey (y, y, y) that stays within [0, high] in every channel.
    double part = 1.0;
    for (const double value : rgb) {
        if (value < 0.0) part = std::min(part, y / (y - value));
        if (value > high) part = std::min(part, (high - y) / (value - y));
    }
    if (part == 1.0) return rgb;
    Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = y + part * (rgb[c] - y);
    return clipped(result, high);  // of the last rounding
}

Vec3 scaled(const Vec3& rgb) noexcept
{
    const double largest = std::ranges::max(rgb);
    Vec3 result = rgb;
    if (largest > 1.0)
        for (double& value : result) value /= largest;
    return clipped(result, 1.0);
}

}  // namespace

GamutMapping gamut_mapping_from_name(std::string_view name)
{
    if (name == "keep") return GamutMapping::keep;
    if (name == "clip") return GamutMapping::clip;
    if (name == "desaturate") return GamutMapping::desaturate;
    if (name == "scale") return GamutMapping::scale;
    throw InputError(
        {.file = {},
         .field = "gamut",
         .message = fmt::format("must be one of keep, clip, desaturate, scale (got '{}')", name)});
}

Vec3 map_to_gamut(const Vec3& rgb, GamutMapping mapping, const Vec3& luminance,
                  ColourOf what) noexcept
{
    switch (mapping) {
        case GamutMapping::clip:
            return clipped(rgb, 1.0);
        case GamutMapping::desaturate:
            return desaturated(
                rgb, luminance,
                what == ColourOf::light ? std::numeric_limits<double>::infinity() : 1.0);
        case GamutMapping::scale:
            return scaled(rgb);
        case GamutMapping::keep:
            break;
    }
    return rgb;
}

RangeMapping range_mapping_from_name(std::string_view name)
{
    if (name == "none") return RangeMapping::none;
    if (name == "clamp") return RangeMapping::clamp;
    if (name == "normalise") return RangeMapping::normalise;
    throw InputError(
        {.file = {},
         .field = "range",
         .message = fmt::format("must be one of none, clamp, normalise (got '{}')", name)});
}

void map_range(std::span<Vec3> colours, RangeMapping mapping) noexcept
{
    if (mapping == RangeMapping::clamp)
        for (Vec3& colour : colours) colour = clipped(colour, 1.0);
    if (mapping != RangeMapping::normalise) return;
    double largest = 0.0;
    for (const Vec3& colour : colours) largest = std::max(largest, std::ranges::max(colour));
    if (!(largest > 0.0)) return;
    for (Vec3& colour : colours)
        for (double& value : colour) value /= largest;
}

}  // namespace nacre::spectral
