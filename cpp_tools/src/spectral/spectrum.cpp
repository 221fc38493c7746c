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
    problems.throw_first_if_any();
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

/// Samples in equal steps and what lies between them.
class SpragueCurve {
public:
    SpragueCurve(double first_nm, double step_nm, const std::vector<double>& values)
        : first_nm_(first_nm), step_nm_(step_nm), extended_(with_sprague_ends(values))
    {}

    /// @pre within the samples
    [[nodiscard]] double at(double nm) const
    {
        const double position = (nm - first_nm_) / step_nm_;
        // Rounding may put the last sample a hair beyond its own position.
        const auto sample = std::min(static_cast<std::size_t>(position), extended_.size() - 6);
        const double x = position - static_cast<double>(sample);
        std::array<double, 6> around;
        std::copy_n(extended_.begin() + static_cast<std::ptrdiff_t>(sample), 6, around.begin());
        return x == 1.0 ? around[3] : sprague(around, x);
    }

private:
    double first_nm_, step_nm_;
    std::vector<double> extended_;
};

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

Interpolation Spectrum::recommended() const noexcept
{
    constexpr std::size_t kFewestForSprague = 6;
    return values_.size() >= kFewestForSprague && is_uniform() ? Interpolation::sprague
                                                               : Interpolation::linear;
}

std::vector<double> Spectrum::values_at(std::span<const double> wavelengths_nm,
                                        Interpolation interpolation) const
{
    std::vector<double> result;
    result.reserve(wavelengths_nm.size());
    const auto fill = [&](const auto& curve) {
        for (const double nm : wavelengths_nm)
            result.push_back(curve.at(std::clamp(nm, first_nm(), last_nm())));
    };
    if (interpolation == Interpolation::sprague) {
        const double step = (last_nm() - first_nm()) / static_cast<double>(values_.size() - 1);
        fill(SpragueCurve(first_nm(), step, values_));
    } else {
        fill(*this);
    }
    return result;
}

Sampled Spectrum::on_grid() const
{
    return on_grid(recommended());
}

Sampled Spectrum::on_grid(Interpolation interpolation) const
{
    if (last_nm() < kFirstNm || first_nm() > kLastNm)
        throw InputError({.file = {},
                          .field = "wavelength_nm",
                          .message = fmt::format("must overlap {} … {} nm (got {} … {})", kFirstNm,
                                                 kLastNm, first_nm(), last_nm())});
    Sampled grid;
    for (std::size_t i = 0; i < kWavelengths; ++i) grid[i] = wavelength_nm(i);
    const std::vector<double> values = values_at(grid, interpolation);
    std::ranges::copy(values, grid.begin());
    return grid;
}

}  // namespace nacre::spectral
