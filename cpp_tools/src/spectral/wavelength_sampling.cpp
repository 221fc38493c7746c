// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/wavelength_sampling.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace nacre::spectral {

namespace {

constexpr std::size_t kSteps = kWavelengths - 1;  ///< intervals of 1 nm
constexpr double kWidestCellNm = 40.0;

/// Probability of each 1 nm interval.
std::array<double, kSteps> interval_density(const ColourWeights& weights, int cells)
{
    std::array<double, kSteps> density;
    double sum = 0.0;
    for (std::size_t i = 0; i < kSteps; ++i) {
        density[i] = 0.0;
        for (const Sampled& weight : weights.weight)
            density[i] += (std::abs(weight[i]) + std::abs(weight[i + 1])) / 2.0;
        sum += density[i];
    }
    // A cell holds 1/cells; this share of a uniform density alone fills one within 40 nm.
    const double uniform_share = static_cast<double>(kSteps) / (kWidestCellNm * cells);
    for (double& p : density)
        p = (1.0 - uniform_share) * p / sum + uniform_share / static_cast<double>(kSteps);
    return density;
}

/// Wavelengths at which the CDF is i / cells.
std::vector<double> equal_cells(const std::array<double, kSteps>& density, int cells)
{
    std::vector<double> edges = {static_cast<double>(kFirstNm)};
    double cdf = 0.0;
    std::size_t step = 0;
    for (int cell = 1; cell < cells; ++cell) {
        const double target = static_cast<double>(cell) / cells;
        while (step + 1 < kSteps && cdf + density[step] < target) cdf += density[step++];
        const double inside = std::clamp((target - cdf) / density[step], 0.0, 1.0);
        edges.push_back(wavelength_nm(step) + inside);
    }
    edges.push_back(static_cast<double>(kLastNm));
    return edges;
}

/// ∫ weight dλ from 360 nm to `nm`, the weight being linear between its samples.
class Integral {
public:
    explicit Integral(const Sampled& weight) : weight_(weight), sum_{}
    {
        for (std::size_t i = 0; i < kSteps; ++i)
            sum_[i + 1] = sum_[i] + (weight[i] + weight[i + 1]) / 2.0;
    }

    [[nodiscard]] double up_to(double nm) const noexcept
    {
        const double offset = nm - kFirstNm;
        const auto i = std::min(static_cast<std::size_t>(offset), kSteps - 1);
        const double x = offset - static_cast<double>(i);
        return sum_[i] + x * (weight_[i] + 0.5 * x * (weight_[i + 1] - weight_[i]));
    }

private:
    const Sampled& weight_;
    Sampled sum_;
};

}  // namespace

WavelengthSampling sample_wavelengths(const ColourWeights& weights, int cells)
{
    assert(cells >= kFewestCells);
    WavelengthSampling sampling;
    sampling.edges_nm = equal_cells(interval_density(weights, cells), cells);
    sampling.weight.resize(static_cast<std::size_t>(cells));
    for (std::size_t c = 0; c < 3; ++c) {
        const Integral integral(weights.weight[c]);
        double white = 0.0;  // what the mean must be: 1 in an RGB space
        for (const double weight : weights.weight[c]) white += weight;
        const double scale = cells * white / integral.up_to(kLastNm);
        for (std::size_t i = 0; i < sampling.weight.size(); ++i)
            sampling.weight[i][c] = scale * (integral.up_to(sampling.edges_nm[i + 1]) -
                                             integral.up_to(sampling.edges_nm[i]));
    }
    return sampling;
}

}  // namespace nacre::spectral
