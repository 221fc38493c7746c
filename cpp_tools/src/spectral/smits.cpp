// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/spectral/rgb_spectrum.h"

namespace nacre::spectral {
namespace {

constexpr std::size_t kBins = 10;
constexpr double kFirstBinNm = 380.0, kBinNm = 34.0;

using Bins = std::array<double, kBins>;

// The table of the paper.
constexpr Bins kWhite = {1.0000, 1.0000, 0.9999, 0.9993, 0.9992,
                         0.9998, 1.0000, 1.0000, 1.0000, 1.0000};
/// Complements of red, green, blue: cyan, magenta, yellow.
constexpr std::array<Bins, 3> kWithout = {
    {{0.9710, 0.9426, 1.0007, 1.0007, 1.0007, 1.0007, 0.1564, 0.0000, 0.0000, 0.0000},
     {1.0000, 1.0000, 0.9685, 0.2229, 0.0000, 0.0458, 0.8369, 1.0000, 1.0000, 0.9959},
     {0.0001, 0.0000, 0.1088, 0.6651, 1.0000, 1.0000, 0.9996, 0.9586, 0.9685, 0.9840}}};
constexpr std::array<Bins, 3> kPrimary = {
    {{0.1012, 0.0515, 0.0000, 0.0000, 0.0000, 0.0000, 0.8325, 1.0149, 1.0149, 1.0149},
     {0.0000, 0.0000, 0.0273, 0.7937, 1.0000, 0.9418, 0.1719, 0.0000, 0.0000, 0.0025},
     {1.0000, 1.0000, 0.8916, 0.3323, 0.0000, 0.0000, 0.0003, 0.0369, 0.0483, 0.0496}}};

void add(Bins& sum, double amount, const Bins& basis)
{
    for (std::size_t i = 0; i < kBins; ++i) sum[i] += amount * basis[i];
}

Sampled on_grid(const Bins& bins)
{
    Sampled values;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const double bin = (wavelength_nm(i) - kFirstBinNm) / kBinNm;
        values[i] = bins[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
    }
    return values;
}

}  // namespace

Sampled smits_spectrum(const Vec3& rgb)
{
    for (const double value : rgb)
        if (!(value >= 0.0 && value <= 1.0))
            throw InputError(
                {.file = {},
                 .field = "rgb",
                 .message = fmt::format("must be in [0, 1] of lin_rec709_scene for the method of "
                                        "Smits (got {}, {}, {})",
                                        rgb[0], rgb[1], rgb[2])});
    // As much white as the least channel has, then the complement of that channel, then the rest.
    std::array<std::size_t, 3> order = {0, 1, 2};
    std::ranges::stable_sort(order, {}, [&rgb](std::size_t channel) { return rgb[channel]; });
    const auto [least, middle, most] = order;
    Bins sum{};
    add(sum, rgb[least], kWhite);
    add(sum, rgb[middle] - rgb[least], kWithout[least]);
    add(sum, rgb[most] - rgb[middle], kPrimary[most]);
    return on_grid(sum);
}

}  // namespace nacre::spectral
