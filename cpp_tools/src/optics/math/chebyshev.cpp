// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "math/chebyshev.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace nacre::optics::detail {

WavenumberBand::WavenumberBand(double first_nm, double last_nm)
    : first_nm_(first_nm),
      last_nm_(last_nm),
      middle_(0.5 * (1.0 / first_nm + 1.0 / last_nm)),
      half_(0.5 * (1.0 / first_nm - 1.0 / last_nm))
{
    assert(0.0 < first_nm && first_nm < last_nm);
}

std::vector<double> WavenumberBand::nodes_nm(std::size_t count) const
{
    assert(count >= 2);
    std::vector<double> nodes(count);
    for (std::size_t k = 0; k < count; ++k)
        nodes[k] = wavelength_nm(
            std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(count - 1)));
    nodes.front() = first_nm_;
    nodes.back() = last_nm_;
    return nodes;
}

/// Discrete cosine transform of the first kind.
template <class Value>
std::vector<Value> chebyshev_coefficients(const std::vector<Value>& values)
{
    const std::size_t last = values.size() - 1, period = 2 * last;
    std::vector<double> cosine(period);
    for (std::size_t m = 0; m < period; ++m)
        cosine[m] = std::cos(std::numbers::pi * static_cast<double>(m) / static_cast<double>(last));
    std::vector<Value> coefficients(values.size());
    for (std::size_t j = 0; j <= last; ++j) {
        Value sum = 0.5 * (values[0] + (j % 2 == 0 ? values[last] : -values[last]));
        for (std::size_t k = 1; k < last; ++k) sum += cosine[j * k % period] * values[k];
        const double share = j == 0 || j == last ? 1.0 : 2.0;
        coefficients[j] = share / static_cast<double>(last) * sum;
    }
    return coefficients;
}

template <class Value>
Value chebyshev_sum(const std::vector<Value>& coefficients, double x)
{
    Value later{}, last{};
    for (std::size_t k = coefficients.size(); k-- > 1;) {
        const Value now = coefficients[k] + 2.0 * x * last - later;
        later = last;
        last = now;
    }
    return coefficients[0] + x * last - later;
}

template <class Value>
Value chebyshev_slope(const std::vector<Value>& coefficients, double x)
{
    Value later{}, last{};
    for (std::size_t k = coefficients.size(); k-- > 1;) {
        const Value now = static_cast<double>(k) * coefficients[k] + 2.0 * x * last - later;
        later = last;
        last = now;
    }
    return last;
}

template std::vector<double> chebyshev_coefficients(const std::vector<double>&);
template std::vector<std::complex<double>> chebyshev_coefficients(
    const std::vector<std::complex<double>>&);
template double chebyshev_sum(const std::vector<double>&, double);
template double chebyshev_slope(const std::vector<double>&, double);
template std::complex<double> chebyshev_slope(const std::vector<std::complex<double>>&, double);
template std::complex<double> chebyshev_sum(const std::vector<std::complex<double>>&, double);

}  // namespace nacre::optics::detail
