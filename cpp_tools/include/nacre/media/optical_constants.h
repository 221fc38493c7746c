// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "nacre/spectral/wavelengths.h"

/// @file
/// Complex refractive indices over wavelength, and what else is known of a medium.

namespace nacre::spectral {

using Complex = std::complex<double>;

/// n + ik of one medium over wavelength.
class OpticalConstants {
public:
    virtual ~OpticalConstants() = default;
    /// @throws InputError outside the range of the data; the message names medium and range.
    [[nodiscard]] virtual Complex at(double wavelength_nm) const = 0;
    /// Closed range in nm: where both n and k are known; {0, inf} for a constant.
    [[nodiscard]] virtual std::array<double, 2> range_nm() const noexcept = 0;
    [[nodiscard]] std::array<Complex, kWavelengths> on_grid() const;
};

using OpticalConstantsPtr = std::shared_ptr<const OpticalConstants>;

/// @throws InputError unless n > 0 and k ≥ 0, both finite.
[[nodiscard]] OpticalConstantsPtr constant_index(Complex n);

/// Values on the 1 nm grid, linear in between.
/// @throws InputError unless n > 0 and k ≥ 0 everywhere, all finite.
[[nodiscard]] OpticalConstantsPtr index_on_grid(const std::array<Complex, kWavelengths>& n);

/// n = a + b/λ² + c/λ⁴ with λ in µm.
[[nodiscard]] OpticalConstantsPtr cauchy(double a, double b, double c = 0.0, double k = 0.0);

/// n² − 1 = Σ B_i λ² / (λ² − C_i), λ in µm, C_i in µm²; up to six terms.
[[nodiscard]] OpticalConstantsPtr sellmeier(std::vector<double> b, std::vector<double> c);

/// Two-term Cauchy curve through n_d with Abbe number V_d (lines F 486.1327, d 587.5618,
/// C 656.2725 nm).
[[nodiscard]] OpticalConstantsPtr abbe(double n_d, double v_d);

/// One entry of the library or one file of the user's.
struct Medium {
    std::string key;         ///< `book/page`, e.g. `water/Daimon-20C`
    std::string name;        ///< readable: first of NAMES in the file, or else the key
    std::string references;  ///< citation, plain text
    std::string comments;
    std::string formula;            ///< chemical, e.g. `TiO2`; FORMULA in the file; may be empty
    std::vector<std::string> tags;  ///< kind of matter, e.g. `metal`; TAGS in the file
    std::vector<std::string> changes = {};  ///< what was put right when the file was read
    OpticalConstantsPtr constants;
};

}  // namespace nacre::spectral
