// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colours/amplitude_series.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>

#include "nacre/core/vector_clones.h"

namespace nacre::optics::detail {
namespace {

using spectral::Vec3;

/// Of |weight|, on either side of the band.
constexpr double kLeftOut = 1e-4;
/// |Δa|² over |a|² from one wavelength to the next; above it there may be a line in between.
constexpr double kLargestTurn = 0.25;
/// Halvings of a nanometre: 0.2 pm.
constexpr int kDeepest = 12;

constexpr std::size_t kVector = 8;  ///< doubles that the sums below take at a time

/// re and im of a, re and im of b, tau.
constexpr std::size_t kParts = 5;
using Parts = std::array<double, kParts>;

/// out[part][i] = Σ_k coefficients[k][part] rows[k][i]
NACRE_VECTOR_CLONES void expand(const double* rows, std::size_t stride, const Parts* coefficients,
                                std::size_t count, double* out)
{
    using V [[gnu::vector_size(kVector * sizeof(double))]] = double;
    for (std::size_t i = 0; i < stride; i += kVector) {
        V sum[kParts] = {};
        for (std::size_t k = 0; k < count; ++k) {
            V row;
            std::memcpy(&row, rows + k * stride + i, sizeof row);
            for (std::size_t part = 0; part < kParts; ++part)
                sum[part] += row * coefficients[k][part];
        }
        for (std::size_t part = 0; part < kParts; ++part)
            std::memcpy(out + part * stride + i, &sum[part], sizeof sum[part]);
    }
}

/// R and T at one wavelength, and the amplitude below both.
struct Sample {
    Complex a;
    double R, T;

    Sample(Complex a_, Complex b, double tau)
        : a(a_), R(std::norm(b) / std::norm(a_)), T(tau / std::norm(a_))
    {}
};

/// Re(u* v)
double dot(Complex u, Complex v)
{
    return u.real() * v.real() + u.imag() * v.imag();
}

bool turns(const Sample& left, const Sample& right)
{
    return std::norm(right.a - left.a) >
           kLargestTurn * std::min(std::norm(left.a), std::norm(right.a));
}

void add(BandSums& sums, const Sample& sample, const Vec3& weight, double share)
{
    for (std::size_t c = 0; c < 3; ++c) {
        sums.reflectance[c] += share * weight[c] * sample.R;
        sums.transmittance[c] += share * weight[c] * sample.T;
    }
}

/// Adds the integral over a part of a nanometre by the trapezoidal rule, halved until nothing
/// turns.
template <class At>
void add_integral(BandSums& sums, const At& at, const BandWeights& weights, std::size_t i,
                  double from, const Sample& left, double to, const Sample& right, int depth)
{
    const double half = 0.5 * (from + to), share = (to - from) / 6.0;
    const Sample middle = at(i, half);
    if (depth < kDeepest && turns(left, right)) {
        add_integral(sums, at, weights, i, from, left, half, middle, depth + 1);
        add_integral(sums, at, weights, i, half, middle, to, right, depth + 1);
        return;
    }
    add(sums, left, weights.density(i, from), share);
    add(sums, middle, weights.density(i, half), 4.0 * share);
    add(sums, right, weights.density(i, to), share);
}

}  // namespace

BandWeights::BandWeights(const spectral::ColourWeights& weights)
{
    Vec3 sum{};
    std::size_t first = spectral::kWavelengths - 2, last = 1;
    for (std::size_t c = 0; c < 3; ++c) {
        for (const double w : weights.weight[c]) sum[c] += std::abs(w);
        double left = 0.0, right = 0.0;
        std::size_t i = 0, j = spectral::kWavelengths - 1;
        while (i < j && (left += std::abs(weights.weight[c][i])) <= kLeftOut * sum[c]) ++i;
        while (j > i && (right += std::abs(weights.weight[c][j])) <= kLeftOut * sum[c]) --j;
        first = std::min(first, i);
        last = std::max(last, j);
    }
    // A single line still has an interval.
    last = std::max(last, first + 1);
    first_nm_ = spectral::wavelength_nm(first);
    for (std::size_t i = first; i <= last; ++i)
        inside_.push_back({weights.weight[0][i], weights.weight[1][i], weights.weight[2][i]});
    weight_ = inside_;
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < first; ++i) weight_.front()[c] += weights.weight[c][i];
        for (std::size_t i = last + 1; i < spectral::kWavelengths; ++i)
            weight_.back()[c] += weights.weight[c][i];
    }
    for (const Vec3& w : inside_) {
        double mean = 0.0;
        for (std::size_t c = 0; c < 3; ++c)
            if (sum[c] > 0.0) mean += std::abs(w[c]) / sum[c] / 3.0;
        importance_.push_back(mean);
    }
}

Vec3 BandWeights::density(std::size_t i, double part) const
{
    const Vec3 &left = inside_[i], &right = inside_[i + 1];
    Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) result[c] = left[c] + part * (right[c] - left[c]);
    return result;
}

ChebyshevRows::ChebyshevRows(const WavenumberBand& band, const BandWeights& weights)
    : x_((weights.size() + kVector - 1) / kVector * kVector)
{
    for (std::size_t i = 0; i < x_.size(); ++i)
        x_[i] = band.x(weights.wavelength_nm(std::min(i, weights.size() - 1)));
}

const double* ChebyshevRows::rows(std::size_t count)
{
    const std::size_t n = x_.size();
    for (std::size_t k = rows_.size() / n; k < count; ++k)
        for (std::size_t i = 0; i < n; ++i)
            rows_.push_back(k == 0 ? 1.0
                            : k == 1
                                ? x_[i]
                                : 2.0 * x_[i] * rows_[(k - 1) * n + i] - rows_[(k - 2) * n + i]);
    return rows_.data();
}

AmplitudeSeries::AmplitudeSeries(const AmplitudeSamples& samples)
    : a_(chebyshev_coefficients(samples.a)),
      b_(chebyshev_coefficients(samples.b)),
      tau_(chebyshev_coefficients(samples.tau))
{}

BandSums AmplitudeSeries::sums(const WavenumberBand& band, const BandWeights& weights,
                               ChebyshevRows& rows) const
{
    std::vector<Parts> coefficients(a_.size());
    for (std::size_t k = 0; k < a_.size(); ++k)
        coefficients[k] = {a_[k].real(), a_[k].imag(), b_[k].real(), b_[k].imag(), tau_[k]};
    const std::size_t stride = rows.stride();
    std::vector<double> parts(kParts * stride);
    expand(rows.rows(a_.size()), stride, coefficients.data(), a_.size(), parts.data());
    const auto sample = [&](std::size_t i) {
        return Sample({parts[i], parts[stride + i]}, {parts[2 * stride + i], parts[3 * stride + i]},
                      parts[4 * stride + i]);
    };
    const auto between = [&](std::size_t i, double part) {
        const double x = band.x(weights.wavelength_nm(i) + part);
        return Sample(chebyshev_sum(a_, x), chebyshev_sum(b_, x), chebyshev_sum(tau_, x));
    };

    // The same without the last two terms.
    const double* last_rows = rows.rows(a_.size()) + (a_.size() - 2) * stride;
    const auto shortened = [&](std::size_t i) {
        const Parts &c = coefficients[a_.size() - 2], &d = coefficients.back();
        const auto part = [&](std::size_t p) {
            return parts[p * stride + i] - c[p] * last_rows[i] - d[p] * last_rows[stride + i];
        };
        return Sample({part(0), part(1)}, {part(2), part(3)}, part(4));
    };

    // What the trapezoidal rule leaves over at the end of a run of nanometres (Euler, Maclaurin).
    const auto add_end = [&](BandSums& sums, std::size_t i, double sign) {
        const double nm = weights.wavelength_nm(i), x = band.x(nm), by_nm = band.slope(nm);
        const Complex a = chebyshev_sum(a_, x), b = chebyshev_sum(b_, x);
        const double power = std::norm(a), tau = chebyshev_sum(tau_, x),
                     a_slope = dot(a, chebyshev_slope(a_, x)) / power;
        Sample slope(a, b, tau);
        slope.R = 2.0 * by_nm * (dot(b, chebyshev_slope(b_, x)) / power - slope.R * a_slope);
        slope.T = by_nm * (chebyshev_slope(tau_, x) / power - 2.0 * slope.T * a_slope);
        add(sums, slope, weights.density(i, 0.0), sign / 12.0);
    };

    BandSums sums;
    Sample here = sample(0);
    bool turned = false;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        add(sums, here, weights[i], 1.0);
        const Sample short_of_it = shortened(i);
        sums.doubt += weights.importance(i) *
                      std::max(std::abs(short_of_it.R - here.R), std::abs(short_of_it.T - here.T));
        if (i + 1 == weights.size()) break;
        const Sample next = sample(i + 1);
        const bool turning = turns(here, next);
        if (turning) {
            // In place of the halves of the two terms that stand for this nanometre.
            add(sums, here, weights.density(i, 0.0), -0.5);
            add(sums, next, weights.density(i, 1.0), -0.5);
            add_integral(sums, between, weights, i, 0.0, here, 1.0, next, 0);
        }
        if (i > 0 && turning != turned) add_end(sums, i, turning ? -1.0 : 1.0);
        turned = turning;
        here = next;
    }
    return sums;
}

}  // namespace nacre::optics::detail
