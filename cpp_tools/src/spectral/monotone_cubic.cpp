// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "nacre/spectral/spectrum_shapes.h"

namespace nacre::spectral {

namespace {

/// Of the parabola through the first three points, whose steps are h0, h1 and whose secants d0, d1;
/// of the sign of d0 and no steeper than three times it.
double end_slope(double h0, double h1, double d0, double d1) noexcept
{
    const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
    if (slope * d0 <= 0.0) return 0.0;
    if (d0 * d1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(d0)) return 3.0 * d0;
    return slope;
}

double inner_slope(double h0, double h1, double d0, double d1) noexcept
{
    if (d0 * d1 <= 0.0) return 0.0;
    const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}

std::vector<double> slopes_of(const Spectrum& points)
{
    const std::vector<double>&x = points.wavelengths_nm(), &y = points.values();
    const std::size_t steps = x.size() - 1;
    std::vector<double> h(steps), secants(steps);
    for (std::size_t i = 0; i < steps; ++i) {
        h[i] = x[i + 1] - x[i];
        secants[i] = (y[i + 1] - y[i]) / h[i];
    }
    std::vector<double> slopes(x.size(), secants.front());
    if (steps == 1) return slopes;
    slopes.front() = end_slope(h[0], h[1], secants[0], secants[1]);
    for (std::size_t i = 1; i < steps; ++i)
        slopes[i] = inner_slope(h[i - 1], h[i], secants[i - 1], secants[i]);
    slopes.back() = end_slope(h[steps - 1], h[steps - 2], secants[steps - 1], secants[steps - 2]);
    return slopes;
}

}  // namespace

MonotoneCubic::MonotoneCubic(Spectrum points)
    : points_(std::move(points)), slopes_(slopes_of(points_))
{}

double MonotoneCubic::at(double wavelength_nm) const
{
    const std::vector<double>&x = points_.wavelengths_nm(), &y = points_.values();
    if (!(wavelength_nm > x.front())) return y.front();
    if (!(wavelength_nm < x.back())) return y.back();
    const auto above = std::ranges::upper_bound(x, wavelength_nm);
    const auto i = static_cast<std::size_t>(above - x.begin()) - 1;
    const double h = x[i + 1] - x[i], t = (wavelength_nm - x[i]) / h, u = 1.0 - t;
    return (1.0 + 2.0 * t) * u * u * y[i] + t * u * u * h * slopes_[i] +
           t * t * (3.0 - 2.0 * t) * y[i + 1] - t * t * u * h * slopes_[i + 1];
}

}  // namespace nacre::spectral
