// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum_files.h"

#include <fmt/format.h>

#include <algorithm>

namespace nacre::spectral {

std::string_view spectrum_kind_name(SpectrumKind kind) noexcept
{
    return kind == SpectrumKind::emission ? "emission" : "reflectance";
}

Sampled NamedSpectrum::on_grid() const
{
    return kind == SpectrumKind::emission ? samples.on_grid(Interpolation::linear)
                                          : samples.on_grid();
}

std::optional<std::string> kind_problem(const Spectrum& samples, SpectrumKind kind)
{
    const auto [lowest, highest] = std::ranges::minmax(samples.values());
    if (kind == SpectrumKind::reflectance) {
        constexpr double kMost = 2.0;
        if (lowest >= 0.0 && highest <= kMost) return std::nullopt;
        return fmt::format(
            "a reflectance must be in [0, {:g}], 1 for all of the light (got {:g} … {:g})", kMost,
            lowest, highest);
    }
    if (lowest < 0.0) return fmt::format("an emission must be ≥ 0 (got {:g})", lowest);
    if (highest == 0.0) return "an emission must be > 0 somewhere";
    return std::nullopt;
}

}  // namespace nacre::spectral
