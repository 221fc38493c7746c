// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "eye.h"
#include "nacre/bands/bands.h"
#include "nonnegative.h"

namespace nacre::bands {

using Eigen::Index, Eigen::MatrixXd, Eigen::RowVectorXd, Eigen::VectorXd;
using spectral::SpectralLine, spectral::Vec3;

namespace {

// Cosines vary where eyes see; reflectances of the library are met by few of them.
constexpr double kCosinesFromNm = 390.0, kCosinesToNm = 720.0;
constexpr Index kMostCosines = 64;
constexpr double kHalfStrength = 4.0;  ///< half periods at which a cosine counts half as much
// Least error over the library's lamps and reflectances, and fringes of films no worse than with
// means: 0.03 … 0.2 hardly differ.
constexpr double kRidge = 0.1;
constexpr double kWhite = 1e3;

double cosine(Index half_periods, double nm)
{
    const double x = (nm - kCosinesFromNm) / (kCosinesToNm - kCosinesFromNm);
    return std::cos(std::numbers::pi * static_cast<double>(half_periods) * std::clamp(x, 0.0, 1.0));
}

double norm(const Vec3& xyz)
{
    return std::hypot(xyz[0], xyz[1], xyz[2]);
}

/// The band that was made for a line, or none.
const Band* band_of_line(const Bands& bands, double nm)
{
    for (const Band& band : bands.bands)
        if (band.is_line && nm >= band.first_nm && nm <= band.last_nm) return &band;
    return nullptr;
}

/// A light on the fine grid, lines without a band of their own in the step that they fall into.
Fine spread_power(const Bands& bands, const Light& light)
{
    Fine power = light.power.empty() ? Fine(kFineWavelengths, 0.0) : light.power;
    for (const SpectralLine& line : light.lines) {
        if (band_of_line(bands, line.wavelength_nm) != nullptr) continue;
        const double step = (line.wavelength_nm - spectral::kFirstNm) / kStepNm;
        const auto i =
            std::min(static_cast<std::size_t>(std::max(step, 0.0)), kFineWavelengths - 1);
        power[i] += line.power / kStepNm;
    }
    return power;
}

/// The eye's mean over each band.
std::vector<double> band_means(const Bands& bands, const Fine& power, const Eye& seen)
{
    std::vector<double> means;
    std::size_t i = 0;
    for (const Band& band : bands.bands) {
        double sum = 0.0, weight = 0.0;
        for (; i < kFineWavelengths && fine_nm(i) < band.last_nm; ++i) {
            sum += seen.sum[i] * power[i];
            weight += seen.sum[i];
        }
        means.push_back(sum / weight);
    }
    return means;
}

std::vector<double> fitted(const Bands& bands, const Fine& power, const Eye& seen)
{
    std::vector<double> means = band_means(bands, power, seen);
    const double luminance = bands.xyz(means)[1];
    if (luminance <= 0.0) return means;

    const auto n = static_cast<Index>(bands.size());
    const Index cosines = std::clamp<Index>(n / 2, 1, kMostCosines);
    // Unknowns are |W_k| S_k / Y, all of the same size.
    VectorXd scale(n);
    for (Index k = 0; k < n; ++k)
        scale[k] = luminance / norm(bands.bands[static_cast<std::size_t>(k)].xyz);
    MatrixXd rows(3 * cosines, n);
    VectorXd targets = VectorXd::Zero(3 * cosines);
    for (Index j = 0; j < cosines; ++j) {
        const double weight =
            (j == 0 ? kWhite : 1.0 / (1.0 + static_cast<double>(j) / kHalfStrength)) / luminance;
        for (Index k = 0; k < n; ++k) {
            const Band& band = bands.bands[static_cast<std::size_t>(k)];
            const double value = weight * scale[k] * cosine(j, band.wavelength_nm);
            for (Index c = 0; c < 3; ++c)
                rows(3 * j + c, k) = value * band.xyz[static_cast<std::size_t>(c)];
        }
        for (std::size_t i = 0; i < kFineWavelengths; ++i) {
            if (power[i] == 0.0) continue;
            const double value = weight * power[i] * kStepNm * cosine(j, fine_nm(i));
            for (Index c = 0; c < 3; ++c)
                targets[3 * j + c] += value * seen.xyz[i][static_cast<std::size_t>(c)];
        }
    }
    VectorXd near(n);
    for (Index k = 0; k < n; ++k) near[k] = means[static_cast<std::size_t>(k)] / scale[k];
    const MatrixXd g = rows.transpose() * rows + kRidge * kRidge * MatrixXd::Identity(n, n);
    const VectorXd x = nonnegative_minimum(g, rows.transpose() * targets + kRidge * kRidge * near);
    for (Index k = 0; k < n; ++k) means[static_cast<std::size_t>(k)] = scale[k] * x[k];
    return means;
}

}  // namespace

std::vector<double> light_in_bands(const Bands& bands, const Light& light)
{
    const Eye& seen = eye(bands.observer);
    std::vector<double> power = fitted(bands, spread_power(bands, light), seen);
    for (const SpectralLine& line : light.lines)
        if (const Band* band = band_of_line(bands, line.wavelength_nm))
            power[static_cast<std::size_t>(band - bands.bands.data())] +=
                line.power * seen.at(line.wavelength_nm)[1] / band->xyz[1];
    return power;
}

}  // namespace nacre::bands
