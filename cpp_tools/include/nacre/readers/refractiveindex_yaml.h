// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nacre/media/optical_constants.h"

/// @file
/// Optical constants as refractiveindex.info has them, and other files brought to that form.

namespace nacre::spectral {

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

}  // namespace nacre::spectral
