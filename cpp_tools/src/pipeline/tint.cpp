// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tint.h"

#include <algorithm>
#include <cmath>

#include "nacre/lut/tint_basis.h"

namespace nacre::pipeline {
namespace {

using spectral::Mat3, spectral::multiply, spectral::transposed, spectral::Vec3;

double mean_between(const spectral::Sampled& values, double first_nm, double last_nm)
{
    const auto index = [](double nm) {
        const double at = std::clamp(nm - spectral::kFirstNm, 0.0,
                                     static_cast<double>(spectral::kWavelengths - 1));
        return static_cast<std::size_t>(std::lround(at));
    };
    const std::size_t first = index(first_nm), last = index(last_nm);
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) sum += values[i];
    return sum / static_cast<double>(last - first + 1);
}

}  // namespace

std::vector<Vec3> tint_basis(const spectral::WavelengthSampling& sampling,
                             const spectral::ColourWeights& weights,
                             const spectral::Sampled& reflectance)
{
    const Mat3 to_rec709 =
        multiply(spectral::colour_space("lin_rec709_scene").from_xyz_d65, weights.to_xyz_d65);
    lut::WavelengthCells cells;
    for (std::size_t i = 0; i < sampling.weight.size(); ++i) {
        const double from = sampling.edges_nm[i], to = sampling.edges_nm[i + 1];
        cells.nm.push_back(0.5 * (from + to));
        cells.weight.push_back(multiply(to_rec709, sampling.weight[i]));
        cells.reflectance.push_back(mean_between(reflectance, from, to));
    }
    std::vector<Vec3> basis = lut::tint_basis(cells);
    // tint_709 · b = (M tint) · b = tint · (Mᵀ b)
    const Mat3 dual = transposed(to_rec709);
    for (Vec3& triple : basis) triple = multiply(dual, triple);
    return basis;
}

}  // namespace nacre::pipeline
