// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <vector>

/// @file
/// Chebyshev polynomials in wavenumber 1/λ over a band of wavelengths.

namespace nacre::optics::detail {

/// Maps 1/λ to [−1, 1], the shortest wavelength to 1.
class WavenumberBand {
public:
    WavenumberBand(double first_nm, double last_nm);

    [[nodiscard]] double first_nm() const { return first_nm_; }
    [[nodiscard]] double last_nm() const { return last_nm_; }
    [[nodiscard]] double x(double wavelength_nm) const
    {
        return (1.0 / wavelength_nm - middle_) / half_;
    }
    [[nodiscard]] double slope(double wavelength_nm) const  ///< dx/dλ
    {
        return -1.0 / (wavelength_nm * wavelength_nm * half_);
    }
    [[nodiscard]] double wavelength_nm(double x) const { return 1.0 / (middle_ + half_ * x); }

    /// The extrema of T_{count−1}, from x = 1 to −1.
    /// @pre count ≥ 2
    [[nodiscard]] std::vector<double> nodes_nm(std::size_t count) const;

private:
    double first_nm_, last_nm_, middle_, half_;
};

/// Coefficients of Σ c_k T_k(x) through values at the nodes.
template <class Value>
[[nodiscard]] std::vector<Value> chebyshev_coefficients(const std::vector<Value>& values);

/// Σ c_k T_k(x), Clenshaw's recurrence.
template <class Value>
[[nodiscard]] Value chebyshev_sum(const std::vector<Value>& coefficients, double x);

/// Its derivative by x: Σ k c_k U_{k−1}(x).
template <class Value>
[[nodiscard]] Value chebyshev_slope(const std::vector<Value>& coefficients, double x);

}  // namespace nacre::optics::detail
