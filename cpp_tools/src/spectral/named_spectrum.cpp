// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/named_spectrum.h"

#include <algorithm>

#include <fmt/format.h>

namespace nacre::spectral {

std::string_view spectrum_kind_name(SpectrumKind kind) noexcept
{
    return kind == SpectrumKind::emission ? "emission" : "reflectance";
}

namespace {

Interpolation interpolation_of(const NamedSpectrum& spectrum)
{
    return spectrum.kind == SpectrumKind::emission ? Interpolation::linear
                                                   : spectrum.samples.recommended();
}

}  // namespace

Sampled NamedSpectrum::on_grid() const
{
    return samples.on_grid(interpolation_of(*this));
}

std::vector<double> NamedSpectrum::values_at(std::span<const double> wavelengths_nm) const
{
    return samples.values_at(wavelengths_nm, interpolation_of(*this));
}

std::optional<std::string> kind_problem(const Spectrum& samples, SpectrumKind kind)
{
    const auto [lowest, highest] = std::ranges::minmax(samples.values());
    if (kind == SpectrumKind::reflectance) {
        constexpr double kMost = 2.0;
        if (lowest >= 0.0 && lowest <= 1.0 && highest <= kMost) return std::nullopt;
        // What fluoresces takes its light from other wavelengths.
        if (lowest > 1.0 && highest <= kMost)
            return fmt::format(
                "a reflectance must be ≤ 1 somewhere, 1 for all of the light (got {:g} … {:g})",
                lowest, highest);
        return fmt::format(
            "a reflectance must be in [0, {:g}], 1 for all of the light (got {:g} … {:g})", kMost,
            lowest, highest);
    }
    if (lowest < 0.0) return fmt::format("an emission must be ≥ 0 (got {:g})", lowest);
    if (highest == 0.0) return "an emission must be > 0 somewhere";
    return std::nullopt;
}

}  // namespace nacre::spectral
