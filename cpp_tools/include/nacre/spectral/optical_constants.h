// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/wavelengths.h"

/// @file
/// Complex refractive indices: refractiveindex.info YAML and closed dispersion formulas.

namespace nacre::spectral {

using Complex = std::complex<double>;

/// n + ik of one medium over wavelength.
class OpticalConstants {
public:
    virtual ~OpticalConstants() = default;
    /// @throws InputError outside the range of the data; the message names medium and range.
    [[nodiscard]] virtual Complex at(double wavelength_nm) const = 0;
    /// Closed range in nm; {0, inf} for a constant.
    [[nodiscard]] virtual std::array<double, 2> range_nm() const noexcept = 0;
    [[nodiscard]] std::array<Complex, kWavelengths> on_grid() const;
};

using OpticalConstantsPtr = std::shared_ptr<const OpticalConstants>;

/// @pre n > 0, k ≥ 0, both finite. @throws InputError otherwise.
[[nodiscard]] OpticalConstantsPtr constant_index(Complex n);

/// n = a + b/λ² + c/λ⁴ with λ in µm.
[[nodiscard]] OpticalConstantsPtr cauchy(double a, double b, double c = 0.0, double k = 0.0);

/// n² − 1 = Σ B_i λ² / (λ² − C_i), λ in µm, C_i in µm²; up to six terms.
[[nodiscard]] OpticalConstantsPtr sellmeier(std::vector<double> b, std::vector<double> c);

/// Two-term Cauchy curve through n_d with Abbe number V_d (lines F 486.13, d 587.56, C 656.27 nm).
[[nodiscard]] OpticalConstantsPtr abbe(double n_d, double v_d);

/// One entry of the library or one file of the user's.
struct Medium {
    std::string key;         ///< `book/page`, e.g. `water/Daimon-20C`
    std::string name;        ///< readable, from the file's comments or the key
    std::string references;  ///< citation, plain text
    std::string comments;
    OpticalConstantsPtr constants;
};

/// Parses refractiveindex.info YAML: only DATA is read (tabulated n, k, nk; formulas 1–9).
/// @param name  what to call the input in messages
/// @throws InputError with line numbers.
[[nodiscard]] Medium parse_refractiveindex_yaml(std::string_view text, std::string_view name);

/// Built-in medium by key; `air` and `vacuum` are n = 1.
/// @throws InputError for an unknown key; the message names near matches.
[[nodiscard]] const Medium& library_medium(std::string_view key);
[[nodiscard]] std::vector<std::string> library_keys();

}  // namespace nacre::spectral
