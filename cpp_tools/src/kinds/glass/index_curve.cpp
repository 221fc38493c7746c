// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "glass/index_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "nacre/spectral/wavelengths.h"

namespace nacre::kinds::glass {
namespace {

constexpr int kHighestDegree = 12;
constexpr double kGoodEnough = 1e-6;

/// Coefficients of T_0, T_1, … of what goes through the values at the Chebyshev points of x.
std::vector<double> chebyshev(int degree, const std::function<double(double)>& at)
{
    const int points = degree + 1;
    std::vector<double> coefficients(static_cast<std::size_t>(points));
    for (int j = 0; j < points; ++j) {
        const double angle = (j + 0.5) * std::numbers::pi / points;
        const double value = at(std::cos(angle));
        for (int k = 0; k < points; ++k)
            coefficients[static_cast<std::size_t>(k)] +=
                (k == 0 ? 1.0 : 2.0) / points * value * std::cos(k * angle);
    }
    return coefficients;
}

/// Of 1, x, x², …, by T_k = 2 x T_{k−1} − T_{k−2}.
std::vector<double> powers(const std::vector<double>& chebyshev)
{
    const std::size_t size = chebyshev.size();
    std::vector<double> result(size), before(size), now(size);
    before[0] = 1.0;
    now[std::min<std::size_t>(1, size - 1)] = 1.0;
    for (std::size_t k = 0; k < size; ++k) {
        const std::vector<double>& polynomial = k == 0 ? before : now;
        for (std::size_t i = 0; i < size; ++i) result[i] += chebyshev[k] * polynomial[i];
        if (k == 0) continue;
        std::vector<double> next(size);
        for (std::size_t i = 0; i < size; ++i)
            next[i] = (i > 0 ? 2.0 * now[i - 1] : 0.0) - before[i];
        before = std::exchange(now, std::move(next));
    }
    return result;
}

double polynomial(const std::vector<double>& power, double x)
{
    double sum = 0.0;
    for (auto it = power.rbegin(); it != power.rend(); ++it) sum = sum * x + *it;
    return sum;
}

}  // namespace

IndexCurve index_curve(const std::function<double(double)>& index)
{
    const double first = 1.0 / spectral::kLastNm, last = 1.0 / spectral::kFirstNm;
    IndexCurve curve{.slope_nm = 2.0 / (last - first),
                     .offset = -(last + first) / (last - first),
                     .power = {},
                     .error = 0.0};
    for (int degree = 1; degree <= kHighestDegree; ++degree) {
        curve.power = powers(chebyshev(
            degree, [&](double x) { return index(curve.slope_nm / (x - curve.offset)); }));
        curve.error = 0.0;
        for (int nm = spectral::kFirstNm; nm <= spectral::kLastNm; ++nm) {
            const double fitted = polynomial(curve.power, curve.slope_nm / nm + curve.offset);
            curve.error = std::max(curve.error, std::abs(fitted - index(nm)));
        }
        if (curve.error <= kGoodEnough) break;
    }
    return curve;
}

}  // namespace nacre::kinds::glass
