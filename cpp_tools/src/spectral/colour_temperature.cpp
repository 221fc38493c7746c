// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "nacre/spectral/colour.h"

namespace nacre::spectral {

namespace {

/// CIE 1960 UCS, in which correlated colour temperature is defined.
struct Uv {
    double u, v;
};

Uv uv_of(const Vec3& xyz) noexcept
{
    const double sum = xyz[0] + 15.0 * xyz[1] + 3.0 * xyz[2];
    return {4.0 * xyz[0] / sum, 6.0 * xyz[1] / sum};
}

Uv locus(double kelvin)
{
    return uv_of(emission_to_xyz(blackbody(kelvin).power, ObserverId::cie1931));
}

double distance(Uv a, Uv b) noexcept
{
    return std::hypot(a.u - b.u, a.v - b.v);
}

struct LocusPoint {
    double kelvin;
    Uv uv;
};

constexpr double kLowestKelvin = 1000.0, kHighestKelvin = 1.0e5;

/// From below the lowest to above the highest temperature in steps of 2 %.
const std::vector<LocusPoint>& locus_table()
{
    static const std::vector<LocusPoint> table = [] {
        std::vector<LocusPoint> points;
        constexpr double kStep = 1.02;
        for (double kelvin = kLowestKelvin / kStep; kelvin < kHighestKelvin * kStep * kStep;
             kelvin *= kStep)
            points.push_back({kelvin, locus(kelvin)});
        return points;
    }();
    return table;
}

/// Minimum of the distance between two temperatures, by golden sections of log T.
double nearest_temperature(Uv uv, double low, double high)
{
    constexpr double kGolden = 0.6180339887498949;
    const auto f = [uv](double log_kelvin) { return distance(uv, locus(std::exp(log_kelvin))); };
    double a = std::log(low), b = std::log(high);
    double x1 = b - kGolden * (b - a), x2 = a + kGolden * (b - a);
    double f1 = f(x1), f2 = f(x2);
    // A minimum cannot be told apart more finely than √ε.
    while (b - a > 1e-8) {
        if (f1 < f2) {
            b = x2, x2 = x1, f2 = f1;
            f1 = f(x1 = b - kGolden * (b - a));
        } else {
            a = x1, x1 = x2, f1 = f2;
            f2 = f(x2 = a + kGolden * (b - a));
        }
    }
    return std::exp((a + b) / 2.0);
}

}  // namespace

std::optional<ColourTemperature> colour_temperature(const Vec3& xyz)
{
    const double sum = xyz[0] + xyz[1] + xyz[2];
    if (!(sum > 0.0) || !std::isfinite(sum)) return std::nullopt;

    const Uv uv = uv_of(xyz);
    const auto& table = locus_table();
    const auto nearest = std::ranges::min_element(
        table, {}, [uv](const LocusPoint& point) { return distance(uv, point.uv); });
    // Nearest to an end: the temperature lies outside the table.
    if (nearest == table.begin() || nearest == table.end() - 1) return std::nullopt;

    const double kelvin =
        nearest_temperature(uv, std::prev(nearest)->kelvin, std::next(nearest)->kelvin);
    constexpr double kRounding = 1e-7;  // of the minimum
    if (kelvin < kLowestKelvin * (1.0 - kRounding) || kelvin > kHighestKelvin * (1.0 + kRounding))
        return std::nullopt;
    const Uv on_locus = locus(kelvin);
    const double duv = std::copysign(distance(uv, on_locus), uv.v - on_locus.v);
    constexpr double kLargestDuv = 0.05;  // CIE 015:2018, 9.4: further off it means nothing
    if (std::abs(duv) > kLargestDuv) return std::nullopt;
    return ColourTemperature{.cct_kelvin = kelvin, .duv = duv};
}

}  // namespace nacre::spectral
