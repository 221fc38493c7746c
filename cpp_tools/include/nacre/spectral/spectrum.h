// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// How to get from the samples of a measurement to the 1 nm grid.
enum class Interpolation {
    linear,
    sprague,  ///< fifth order, for samples in equal steps: CIE 167:2005
};

/// A sampled function of wavelength: ascending wavelengths in nm, any spacing.
class Spectrum {
public:
    /// @throws InputError when the sizes differ, there are fewer than two samples, wavelengths do
    ///         not ascend, or a number is not finite.
    Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

    [[nodiscard]] double first_nm() const noexcept { return wavelengths_nm_.front(); }
    [[nodiscard]] double last_nm() const noexcept { return wavelengths_nm_.back(); }
    [[nodiscard]] const std::vector<double>& wavelengths_nm() const noexcept
    {
        return wavelengths_nm_;
    }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

    /// Linear interpolation.
    /// @throws InputError outside [first_nm, last_nm]; the message names the range.
    [[nodiscard]] double at(double wavelength_nm) const;

    /// On the 1 nm grid as the CIE recommends for measured spectra: Sprague where six or more
    /// samples stand in equal steps (CIE 167:2005), else linear; outside the samples the value of
    /// the nearest one (CIE 015:2018, 7.2.3).
    /// @throws InputError when no sample range overlaps the grid.
    [[nodiscard]] Sampled on_grid() const;

    /// The same with a chosen interpolation. @pre sprague: six or more samples in equal steps
    [[nodiscard]] Sampled on_grid(Interpolation interpolation) const;

    /// At any wavelengths; outside the samples the value of the nearest one.
    /// @pre sprague: six or more samples in equal steps
    [[nodiscard]] std::vector<double> values_at(std::span<const double> wavelengths_nm,
                                                Interpolation interpolation) const;

    /// What on_grid() takes: Sprague where it can be.
    [[nodiscard]] Interpolation recommended() const noexcept;

private:
    [[nodiscard]] bool is_uniform() const noexcept;

    std::vector<double> wavelengths_nm_, values_;
};

}  // namespace nacre::spectral
