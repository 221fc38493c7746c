// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

void check_samples(const std::vector<double>& wavelengths_nm, const std::vector<double>& values)
{
    DiagnosticList problems;
    if (wavelengths_nm.size() < 2)
        problems.add({.file = {},
                      .field = "wavelength_nm",
                      .message = fmt::format("must hold at least two samples (got {})",
                                             wavelengths_nm.size())});
    if (wavelengths_nm.size() != values.size())
        problems.add({.file = {},
                      .field = "values",
                      .message = fmt::format("must be as many as the wavelengths (got {} for {})",
                                             values.size(), wavelengths_nm.size())});
    for (std::size_t i = 0; i < wavelengths_nm.size(); ++i) {
        const bool good = std::isfinite(wavelengths_nm[i]) && wavelengths_nm[i] > 0.0 &&
                          (i == 0 || !(wavelengths_nm[i] <= wavelengths_nm[i - 1]));
        if (!good)
            problems.add({.file = {},
                          .field = fmt::format("wavelength_nm[{}]", i),
                          .message = fmt::format("must be finite, > 0 and ascending (got {})",
                                                 wavelengths_nm[i])});
    }
    for (std::size_t i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            problems.add({.file = {},
                          .field = fmt::format("values[{}]", i),
                          .message = fmt::format("must be finite (got {})", values[i])});
    problems.throw_if_any();
}

/// Value at `x` in [0, 1] between y[2] and y[3]; CIE 167:2005, after Sprague 1880.
double sprague(const std::array<double, 6>& y, double x) noexcept
{
    const double a1 = (2 * y[0] - 16 * y[1] + 16 * y[3] - 2 * y[4]) / 24;
    const double a2 = (-y[0] + 16 * y[1] - 30 * y[2] + 16 * y[3] - y[4]) / 24;
    const double a3 = (-9 * y[0] + 39 * y[1] - 70 * y[2] + 66 * y[3] - 33 * y[4] + 7 * y[5]) / 24;
    const double a4 =
        (13 * y[0] - 64 * y[1] + 126 * y[2] - 124 * y[3] + 61 * y[4] - 12 * y[5]) / 24;
    const double a5 = (-5 * y[0] + 25 * y[1] - 50 * y[2] + 50 * y[3] - 25 * y[4] + 5 * y[5]) / 24;
    return ((((a5 * x + a4) * x + a3) * x + a2) * x + a1) * x + y[2];
}

/// Two more samples at each end, from the six next to it; CIE 167:2005.
std::vector<double> with_sprague_ends(const std::vector<double>& values)
{
    constexpr std::array<double, 6> kOuter = {884, -1960, 3033, -2648, 1080, -180};
    constexpr std::array<double, 6> kInner = {508, -540, 488, -367, 144, -24};
    const std::size_t last = values.size() - 1;
    const auto weighted = [&](const std::array<double, 6>& weight, bool from_end) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 6; ++i) sum += weight[i] * values[from_end ? last - i : i];
        return sum / 209;
    };
    std::vector<double> extended = {weighted(kOuter, false), weighted(kInner, false)};
    extended.insert(extended.end(), values.begin(), values.end());
    extended.push_back(weighted(kInner, true));
    extended.push_back(weighted(kOuter, true));
    return extended;
}

}  // namespace

Spectrum::Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values)
    : wavelengths_nm_(std::move(wavelengths_nm)), values_(std::move(values))
{
    check_samples(wavelengths_nm_, values_);
}

double Spectrum::at(double wavelength_nm) const
{
    if (!(wavelength_nm >= first_nm() && wavelength_nm <= last_nm()))
        throw InputError({.file = {},
                          .field = "wavelength_nm",
                          .message = fmt::format("must be within the samples, {} … {} nm (got {})",
                                                 first_nm(), last_nm(), wavelength_nm)});
    const auto above = std::ranges::lower_bound(wavelengths_nm_, wavelength_nm);
    const auto i = static_cast<std::size_t>(above - wavelengths_nm_.begin());
    if (*above == wavelength_nm) return values_[i];
    const double x =
        (wavelength_nm - wavelengths_nm_[i - 1]) / (wavelengths_nm_[i] - wavelengths_nm_[i - 1]);
    return values_[i - 1] + x * (values_[i] - values_[i - 1]);
}

bool Spectrum::is_uniform() const noexcept
{
    const double step = wavelengths_nm_[1] - wavelengths_nm_[0];
    for (std::size_t i = 2; i < wavelengths_nm_.size(); ++i)
        if (std::abs(wavelengths_nm_[i] - wavelengths_nm_[i - 1] - step) > 1e-6 * step)
            return false;
    return true;
}

Sampled Spectrum::on_grid() const
{
    constexpr std::size_t kFewestForSprague = 6;
    return on_grid(is_uniform() && values_.size() >= kFewestForSprague ? Interpolation::sprague
                                                                       : Interpolation::linear);
}

Sampled Spectrum::on_grid(Interpolation interpolation) const
{
    if (last_nm() < kFirstNm || first_nm() > kLastNm)
        throw InputError({.file = {},
                          .field = "wavelength_nm",
                          .message = fmt::format("must overlap {} … {} nm (got {} … {})", kFirstNm,
                                                 kLastNm, first_nm(), last_nm())});
    const bool is_sprague = interpolation == Interpolation::sprague;
    const std::vector<double> extended =
        is_sprague ? with_sprague_ends(values_) : std::vector<double>{};
    const auto intervals = static_cast<double>(values_.size() - 1);
    const double step = (last_nm() - first_nm()) / intervals;

    Sampled sampled;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const double nm = std::clamp(wavelength_nm(i), first_nm(), last_nm());
        if (!is_sprague) {
            sampled[i] = at(nm);
            continue;
        }
        const double position = (nm - first_nm()) / step;
        const double whole = std::clamp(std::floor(position), 0.0, intervals - 1.0);
        std::array<double, 6> around;
        std::copy_n(extended.begin() + static_cast<std::ptrdiff_t>(whole), 6, around.begin());
        sampled[i] = sprague(around, position - whole);
    }
    return sampled;
}

}  // namespace nacre::spectral
