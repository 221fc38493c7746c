// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/spectral/wavelengths.h"

namespace nacre::spectral {

/// A sampled function of wavelength: ascending wavelengths in nm, any spacing, linear in between.
class Spectrum {
public:
    /// @throws InputError when the sizes differ, there are fewer than two samples, wavelengths do
    ///         not ascend, or a number is not finite.
    Spectrum(std::vector<double> wavelengths_nm, std::vector<double> values);

    [[nodiscard]] double first_nm() const noexcept { return wavelengths_nm_.front(); }
    [[nodiscard]] double last_nm() const noexcept { return wavelengths_nm_.back(); }
    [[nodiscard]] const std::vector<double>& wavelengths_nm() const noexcept { return wavelengths_nm_; }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }

    /// Linear interpolation. @throws InputError outside [first_nm, last_nm]; the message names the range.
    [[nodiscard]] double at(double wavelength_nm) const;

    /// On the 1 nm grid, 0 outside the range of the samples: for emission and reflectance whose
    /// tables stop short of 360 or 830 nm (convention of ASTM E308 is left to the caller).
    [[nodiscard]] Sampled on_grid() const;

private:
    std::vector<double> wavelengths_nm_, values_;
};

}  // namespace nacre::spectral
