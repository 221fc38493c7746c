// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/colour.h"

#include <cmath>
#include <numeric>

namespace nacre::spectral {

namespace {

/// Σ values · x̄, ȳ, z̄ over the grid.
Vec3 integrate(const Sampled& values, const Observer& observer) noexcept
{
    return {std::inner_product(values.begin(), values.end(), observer.x.begin(), 0.0),
            std::inner_product(values.begin(), values.end(), observer.y.begin(), 0.0),
            std::inner_product(values.begin(), values.end(), observer.z.begin(), 0.0)};
}

Vec3 scaled(const Vec3& v, double factor) noexcept
{
    return {v[0] * factor, v[1] * factor, v[2] * factor};
}

}  // namespace

Vec3 emission_to_xyz(const Sampled& radiance, ObserverId observer_id)
{
    const Observer& cmf = observer(observer_id);
    return scaled(integrate(radiance, cmf), 1.0 / cmf.sum_y);
}

Vec3 reflectance_to_xyz(const Sampled& reflectance, const Illuminant& illuminant,
                        ObserverId observer_id)
{
    const Observer& cmf = observer(observer_id);
    Sampled reflected;
    for (std::size_t i = 0; i < kWavelengths; ++i)
        reflected[i] = reflectance[i] * illuminant.power[i];
    const double white = integrate(illuminant.power, cmf)[1];
    return scaled(integrate(reflected, cmf), 1.0 / white);
}

Vec3 white_under(const Illuminant& illuminant, ObserverId observer_id)
{
    Sampled perfect;
    perfect.fill(1.0);
    return reflectance_to_xyz(perfect, illuminant, observer_id);
}

std::array<double, 2> xyz_to_xy(const Vec3& xyz) noexcept
{
    const double sum = xyz[0] + xyz[1] + xyz[2];
    // Black has no chromaticity; the one of the equal-energy white keeps it finite.
    if (sum == 0.0) return {1.0 / 3.0, 1.0 / 3.0};
    return {xyz[0] / sum, xyz[1] / sum};
}

Vec3 xyz_to_lab(const Vec3& xyz, const Vec3& white) noexcept
{
    // CIE 015:2018, equations 8.3 to 8.11.
    const auto f = [](double t) {
        constexpr double kBreak = (24.0 / 116.0) * (24.0 / 116.0) * (24.0 / 116.0);
        return t > kBreak ? std::cbrt(t) : (841.0 / 108.0) * t + 16.0 / 116.0;
    };
    const double fx = f(xyz[0] / white[0]);
    const double fy = f(xyz[1] / white[1]);
    const double fz = f(xyz[2] / white[2]);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

Vec3 ColourWeights::apply(const Sampled& reflectance) const noexcept
{
    Vec3 colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] =
            std::inner_product(reflectance.begin(), reflectance.end(), weight[c].begin(), 0.0);
    return colour;
}

Vec3 ColourWeights::white() const noexcept
{
    Sampled one;
    one.fill(1.0);
    return apply(one);
}

Vec3 emission_white(ObserverId observer_id)
{
    if (observer_id == ObserverId::cie1931) return d65_white();
    const Vec3 white = emission_to_xyz(cie_illuminant("D65").power, observer_id);
    return scaled(white, 1.0 / white[1]);
}

Mat3 emission_to_d65(ObserverId observer_id)
{
    return observer_id == ObserverId::cie1931
               ? adaptation(Adaptation::none, {}, {})
               : adaptation(Adaptation::bradford, emission_white(observer_id), d65_white());
}

ColourWeights reflectance_weights(const Illuminant& illuminant, ObserverId observer_id,
                                  const ColourSpace& space, Adaptation how)
{
    const Vec3 white = white_under(illuminant, observer_id);
    const Mat3 from_xyz = multiply(space.from_xyz_d65, adaptation(how, white, d65_white()));

    const Observer& cmf = observer(observer_id);
    const double k = 1.0 / integrate(illuminant.power, cmf)[1];
    ColourWeights weights{.weight = {},
                          .space = space.name,
                          .illuminant = illuminant.name,
                          .observer = observer_id,
                          .to_xyz_d65 = space.to_xyz_d65};
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const Vec3 rgb =
            multiply(from_xyz, scaled({cmf.x[i], cmf.y[i], cmf.z[i]}, k * illuminant.power[i]));
        for (std::size_t c = 0; c < 3; ++c) weights.weight[c][i] = rgb[c];
    }
    return weights;
}

}  // namespace nacre::spectral
