// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "plot/colours.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace nacre::tool {
namespace {

using spectral::Vec3;

double encoded(double linear)
{
    const double value = std::clamp(linear, 0.0, 1.0);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
}

/// The hue of one wavelength at full strength.
Vec3 hue(std::size_t i)
{
    const spectral::Observer& eye = spectral::observer(spectral::ObserverId::cie1931);
    const auto& to_rgb = spectral::colour_space("lin_rec709_scene").from_xyz_d65;
    Vec3 rgb{};
    for (std::size_t c = 0; c < 3; ++c)
        rgb[c] = to_rgb[c][0] * eye.x[i] + to_rgb[c][1] * eye.y[i] + to_rgb[c][2] * eye.z[i];
    const double most = *std::ranges::max_element(rgb);
    for (double& channel : rgb) channel = std::max(channel / most, 0.0);
    return rgb;
}

/// How much of the fill is seen: all of it from 420 to 680 nm, nothing outside 380 … 760 nm.
double strength(double nm)
{
    return std::clamp(std::min((nm - 380.0) / 40.0, (760.0 - nm) / 80.0), 0.0, 1.0);
}

}  // namespace

Paint screen_paint(const Vec3& rgb)
{
    return {encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2])};
}

std::string hexadecimal(const Paint& paint)
{
    const auto byte = [](double value) { return std::lround(255.0 * value); };
    return fmt::format("#{:02X}{:02X}{:02X}", byte(paint.red), byte(paint.green), byte(paint.blue));
}

std::vector<GradientStop> visible_spectrum(double first_nm, double last_nm)
{
    constexpr int kFirst = 380, kLast = 760, kStep = 5;
    std::vector<GradientStop> stops;
    for (int nm = kFirst; nm <= kLast; nm += kStep) {
        const double position = (nm - first_nm) / (last_nm - first_nm);
        if (position < 0.0 || position > 1.0) continue;
        Paint paint = screen_paint(hue(static_cast<std::size_t>(nm - spectral::kFirstNm)));
        paint.alpha = strength(nm);
        stops.push_back({position, paint});
    }
    return stops;
}

}  // namespace nacre::tool
