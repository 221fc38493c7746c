// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/spectral/colour.h"

namespace nacre::spectral {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Hue angle in [0, 360); 0 for a grey.
double hue_degrees(double a, double b) noexcept
{
    if (a == 0.0 && b == 0.0) return 0.0;
    const double degrees = std::atan2(b, a) * kDegrees;
    return degrees < 0.0 ? degrees + 360.0 : degrees;
}

double cos_degrees(double degrees) noexcept
{
    return std::cos(degrees / kDegrees);
}
double sin_degrees(double degrees) noexcept
{
    return std::sin(degrees / kDegrees);
}

/// √(C⁷ / (C⁷ + 25⁷))
double chroma_root(double chroma) noexcept
{
    const double c7 = std::pow(chroma, 7);
    constexpr double k25To7 = 6103515625.0;
    return std::sqrt(c7 / (c7 + k25To7));
}

/// Difference and mean of two hues, equations 10 and 14; `grey`: one of the two has no hue.
struct HuePair {
    double difference, mean;
};
HuePair hue_pair(double h1, double h2, bool grey) noexcept
{
    if (grey) return {0.0, h1 + h2};
    const double difference = h2 - h1;
    const double sum = h1 + h2;
    if (std::abs(difference) <= 180.0) return {difference, sum / 2.0};
    return {difference > 0.0 ? difference - 360.0 : difference + 360.0,
            sum < 360.0 ? (sum + 360.0) / 2.0 : (sum - 360.0) / 2.0};
}

}  // namespace

// Equation numbers: Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference formula:
// implementation notes, supplementary test data, and mathematical observations".
double delta_e_2000(const Vec3& lab_a, const Vec3& lab_b) noexcept
{
    const auto [l1, a1, b1] = lab_a;
    const auto [l2, a2, b2] = lab_b;

    // 2 to 7
    const double g = 0.5 * (1.0 - chroma_root((std::hypot(a1, b1) + std::hypot(a2, b2)) / 2.0));
    const double a1p = (1.0 + g) * a1, a2p = (1.0 + g) * a2;
    const double c1p = std::hypot(a1p, b1), c2p = std::hypot(a2p, b2);

    // 8 to 14
    const HuePair hue =
        hue_pair(hue_degrees(a1p, b1), hue_degrees(a2p, b2), c1p == 0.0 || c2p == 0.0);
    const double dl = l2 - l1, dc = c2p - c1p;
    const double dh = 2.0 * std::sqrt(c1p * c2p) * sin_degrees(hue.difference / 2.0);
    const double l_mean = (l1 + l2) / 2.0, c_mean = (c1p + c2p) / 2.0;

    // 15 to 21
    const double t = 1.0 - 0.17 * cos_degrees(hue.mean - 30.0) +
                     0.24 * cos_degrees(2.0 * hue.mean) + 0.32 * cos_degrees(3.0 * hue.mean + 6.0) -
                     0.20 * cos_degrees(4.0 * hue.mean - 63.0);
    const double theta = 30.0 * std::exp(-std::pow((hue.mean - 275.0) / 25.0, 2));
    const double l50 = (l_mean - 50.0) * (l_mean - 50.0);
    const double s_l = 1.0 + 0.015 * l50 / std::sqrt(20.0 + l50);
    const double s_c = 1.0 + 0.045 * c_mean;
    const double s_h = 1.0 + 0.015 * c_mean * t;
    const double r_t = -sin_degrees(2.0 * theta) * 2.0 * chroma_root(c_mean);

    // 22; a rounding error must not make the root of a tiny negative number
    const double l = dl / s_l, c = dc / s_c, h = dh / s_h;
    return std::sqrt(std::max(0.0, l * l + c * c + h * h + r_t * c * h));
}

}  // namespace nacre::spectral
