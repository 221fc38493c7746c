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

/// Parses refractiveindex.info YAML: numbers come from DATA only (tabulated n, k, nk; formulas
/// 1–9). Tables are linear in between; where n and k have ranges of their own, theirs in common
/// counts, but k is 0 beyond the end of a table that ends with 0 where a formula of n goes on. What
/// published files have wrong is put right, and Medium::changes says so: rows out of order, a
/// wavelength twice, k of noise below 0, n stated twice and alike.
/// @param name  what to call the input in messages, and the medium's key
/// @throws InputError with line numbers.
[[nodiscard]] Medium parse_refractiveindex_yaml(std::string_view text, std::string_view name);

/// The YAML of a table in CSV as read_csv_spectra() has it, with columns `n` and perhaps `k`, or
/// with a table of each as refractiveindex.info exports them.
/// @param references  citation; empty: that of the file's comments
/// @param changes     what was put right in the rows is added to it, and kept as COMMENTS
/// @throws InputError with line numbers.
[[nodiscard]] std::string refractiveindex_yaml_from_csv(std::string_view text,
                                                        std::string_view name,
                                                        std::string_view references,
                                                        std::vector<std::string>& changes);

/// The same of a pair of `.spd` files as pbrt has them of metals, `Au.eta.spd` and `Au.k.spd`: at
/// the wavelengths of both, linear in between, over the range that they share.
/// @throws InputError with all that is wrong with either.
[[nodiscard]] std::string refractiveindex_yaml_from_spd(
    std::string_view n_text, std::string_view n_name, std::string_view k_text,
    std::string_view k_name, std::string_view references, std::vector<std::string>& changes);

/// The YAML of one file of optical constants, as a library keeps it: `.yml` and `.yaml` as they
/// are, anything else as CSV. What comes back can be parsed.
/// @param references  citation; refused for a YAML file that states its own
/// @param changes     what is put right when it is read is added to it
/// @throws InputError with line numbers.
[[nodiscard]] std::string refractiveindex_yaml_of_file(std::string_view text, std::string_view file,
                                                       std::string_view references,
                                                       std::vector<std::string>& changes);

/// A medium that comes with Nacre or is the user's own, by key; `air` and `vacuum` are n = 1.
/// Thread-safe; the reference stays valid.
/// @throws InputError for an unknown key; the message names near matches.
[[nodiscard]] const Medium& library_medium(std::string_view key);
[[nodiscard]] std::vector<std::string> library_keys();

}  // namespace nacre::spectral
