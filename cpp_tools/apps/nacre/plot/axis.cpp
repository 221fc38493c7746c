// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "plot/axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace nacre::tool {
namespace {

/// 1, 2 or 5 times a power of ten: at most eight of them in `width`.
double round_step(double width)
{
    constexpr double kMost = 8.0;
    const double decade = std::pow(10.0, std::floor(std::log10(width / kMost)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (width / (factor * decade) <= kMost) return factor * decade;
    return 10.0 * decade;
}

/// Superscripts: 10⁻³.
std::string power_of_ten(int exponent)
{
    constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "10⁻" : "10";
    for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[digit - '0'];
    return text;
}

}  // namespace

void Axis::label_steps(double step)
{
    constexpr int kMost = 12;  // of numbers so far apart that steps are lost in them, too
    const double first = std::ceil(low_ / step - 1e-9);
    for (int i = 0; i < kMost; ++i) {
        // Neither -0 nor 0.30000000000000004.
        const double value = first + i == 0.0 ? 0.0 : (first + i) * step;
        if (!(value <= high_ + 1e-9 * step)) break;
        ticks_.push_back({value, fmt::format("{:.6g}", value)});
    }
}

Axis Axis::exactly(double low, double high, double from, double to)
{
    Axis axis(low, high, from, to);
    axis.label_steps(round_step(high - low));
    return axis;
}

Axis Axis::rounded(double low, double high, double from, double to)
{
    const double step = round_step(high - low);
    Axis axis(std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, from, to);
    axis.label_steps(step);
    return axis;
}

Axis Axis::decades(double low, double high, double from, double to)
{
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::max(first + 1.0, std::ceil(std::log10(high) - 1e-9));
    Axis axis(first, last, from, to);
    axis.logarithmic_ = true;
    constexpr double kMost = 8.0;
    const double step = std::ceil((last - first) / kMost);
    for (double i = first; i <= last; i += step)
        axis.ticks_.push_back({std::pow(10.0, i), power_of_ten(static_cast<int>(i))});
    return axis;
}

double Axis::place(double value) const
{
    double at = value;
    if (logarithmic_) at = value > 0.0 ? std::max(std::log10(value), low_) : low_;
    return from_ + (at - low_) / (high_ - low_) * (to_ - from_);
}

}  // namespace nacre::tool
