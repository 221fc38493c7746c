// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/tabulated_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

constexpr double kNmPerUm = 1000.0;

class MeasuredConstants final : public OpticalConstants {
public:
    explicit MeasuredConstants(MeasuredIndex index) : index_(std::move(index))
    {
        range_um_ = n_range_um();
        if (index_.k) {
            const auto k_range = index_.k->range_um();
            range_um_ = {std::max(range_um_[0], k_range[0]), std::min(range_um_[1], k_range[1])};
        }
        if (range_um_[0] > range_um_[1])
            throw InputError({.file = index_.name,
                              .field = "DATA",
                              .message = "n and k must have wavelengths in common"});
    }

    [[nodiscard]] Complex at(double wavelength_nm) const override
    {
        // In the unit of the file, where 0.83 and 830 / 1000 are the same double; in nm also, for
        // who asks at an end that range_nm() gave.
        const auto [low_um, high_um] = range_um_;
        const auto [low_nm, high_nm] = range_nm();
        const double um = std::clamp(wavelength_nm / kNmPerUm, low_um, high_um);
        if (um != wavelength_nm / kNmPerUm && wavelength_nm != low_nm && wavelength_nm != high_nm)
            throw InputError({.file = index_.name,
                              .field = "wavelength_nm",
                              .message = fmt::format(
                                  "must be within the data, {:.10g} … {:.10g} nm (got {:.10g})",
                                  low_nm, high_nm, wavelength_nm)});
        const double n = n_at(um);
        if (!(n > 0.0) || !std::isfinite(n))
            throw InputError({.file = index_.name,
                              .field = "coefficients",
                              .message = fmt::format("give no index n > 0 at {:.10g} nm (got {})",
                                                     wavelength_nm, n)});
        return {n, index_.k ? index_.k->at(um) : 0.0};
    }

    [[nodiscard]] std::array<double, 2> range_nm() const noexcept override
    {
        return {range_um_[0] * kNmPerUm, range_um_[1] * kNmPerUm};
    }

private:
    [[nodiscard]] std::array<double, 2> n_range_um() const noexcept
    {
        if (const auto* table = std::get_if<IndexTable>(&index_.n)) return table->range_um();
        return std::get_if<RangedFormula>(&index_.n)->range_um;
    }

    [[nodiscard]] double n_at(double um) const
    {
        if (const auto* table = std::get_if<IndexTable>(&index_.n)) return table->at(um);
        return std::get_if<RangedFormula>(&index_.n)->formula.index_at(um);
    }

    MeasuredIndex index_;
    std::array<double, 2> range_um_{};
};

}  // namespace

double IndexTable::at(double um) const
{
    const auto above = std::ranges::lower_bound(wavelengths_um, um);
    const auto i = static_cast<std::size_t>(above - wavelengths_um.begin());
    if (wavelengths_um[i] == um) return values[i];
    const double x = (um - wavelengths_um[i - 1]) / (wavelengths_um[i] - wavelengths_um[i - 1]);
    return values[i - 1] + x * (values[i] - values[i - 1]);
}

std::array<double, 2> IndexTable::range_um() const noexcept
{
    return {wavelengths_um.front(), wavelengths_um.back()};
}

OpticalConstantsPtr measured_constants(MeasuredIndex index)
{
    return std::make_shared<MeasuredConstants>(std::move(index));
}

}  // namespace nacre::spectral
