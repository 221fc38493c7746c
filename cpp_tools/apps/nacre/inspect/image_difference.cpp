// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "inspect/image_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tbb/parallel_for.h>

#include "colour/target.h"

namespace nacre::tool {
namespace {

using spectral::Vec3;

/// IEC 61966-2-1
double from_srgb_curve(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::array<std::size_t, 3> colour_channels(const std::vector<std::string>& names)
{
    std::array<std::size_t, 3> channels{};
    const char* wanted[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto found = std::find(names.begin(), names.end(), wanted[c]);
        if (found == names.end())
            return names.size() < 3 ? std::array<std::size_t, 3>{0, 0, 0}
                                    : std::array<std::size_t, 3>{0, 1, 2};
        channels[c] = static_cast<std::size_t>(found - names.begin());
    }
    return channels;
}

bool is_finite(const Vec3& v)
{
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace

std::vector<Vec3> linear_pixels(const LoadedImage& loaded)
{
    const Image& image = loaded.image;
    const auto channels = colour_channels(image.channels);
    std::vector<Vec3> pixels(image.pixels.size() / image.channel_count());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = image.pixels[i * image.channel_count() + channels[c]];
            pixels[i][c] = loaded.display_encoded ? from_srgb_curve(value) : value;
        }
    return pixels;
}

ImageDifference compare_pixels(const std::vector<Vec3>& a, const std::vector<Vec3>& b, int width,
                               const spectral::ColourSpace& space)
{
    const Vec3 white = spectral::d65_white();
    const auto lab = [&](const Vec3& rgb) {
        return spectral::xyz_to_lab(multiply(space.to_xyz_d65, rgb), white);
    };
    ImageDifference result;
    result.delta_e.resize(a.size(), std::numeric_limits<float>::quiet_NaN());
    tbb::parallel_for(std::size_t{0}, a.size(), [&](std::size_t i) {
        if (is_finite(a[i]) && is_finite(b[i]))
            result.delta_e[i] = static_cast<float>(spectral::delta_e_2000(lab(a[i]), lab(b[i])));
    });

    double sum = 0.0, squares = 0.0;
    std::int64_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!is_finite(a[i]) || !is_finite(b[i])) continue;
        ++count;
        sum += static_cast<double>(result.delta_e[i]);
        for (std::size_t c = 0; c < 3; ++c) squares += (a[i][c] - b[i][c]) * (a[i][c] - b[i][c]);
        if (count > 1 && static_cast<double>(result.delta_e[i]) <= result.max) continue;
        result.max = static_cast<double>(result.delta_e[i]);
        result.worst_x = static_cast<int>(i % static_cast<std::size_t>(width));
        result.worst_y = static_cast<int>(i / static_cast<std::size_t>(width));
    }
    result.not_finite = static_cast<std::int64_t>(a.size()) - count;
    if (count > 0) {
        result.mean = sum / static_cast<double>(count);
        result.rmse = std::sqrt(squares / (3.0 * static_cast<double>(count)));
    }
    return result;
}

}  // namespace nacre::tool
