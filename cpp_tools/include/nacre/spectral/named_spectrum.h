// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/spectrum.h"

/// @file
/// What spectra are of, and what else is known of them.

namespace nacre::spectral {

enum class SpectrumKind {
    emission,     ///< relative power, ≥ 0
    reflectance,  ///< or transmittance: a ratio, 0 … 1; fluorescence may go beyond
};

[[nodiscard]] std::string_view spectrum_kind_name(SpectrumKind kind) noexcept;

/// A spectrum and where it comes from.
struct NamedSpectrum {
    std::string key;   ///< in a library; empty for a file
    std::string name;  ///< readable
    std::string references, licence, comments;
    std::vector<std::string> tags;
    std::optional<SpectrumKind> kind;  ///< nothing where a file does not tell
    Spectrum samples;
    /// Whether a file says that its reflectances are ratios, or per cent, which are ratios here.
    bool unit_stated = false;
    /// What the file says where what its reader was told took the place of it.
    std::optional<SpectrumKind> overridden = {};

    /// Reflectances as Spectrum::on_grid() has it; emissions linear, as the CIE reads illuminants.
    [[nodiscard]] Sampled on_grid() const;
    /// The same at any wavelengths: Spectrum::values_at().
    [[nodiscard]] std::vector<double> values_at(std::span<const double> wavelengths_nm) const;
};

/// What is wrong with the values for the kind: a reflectance outside 0 … 2 or above 1 everywhere,
/// an emission that is negative somewhere or 0 everywhere; nothing for a good one.
[[nodiscard]] std::optional<std::string> kind_problem(const Spectrum& samples, SpectrumKind kind);

}  // namespace nacre::spectral
