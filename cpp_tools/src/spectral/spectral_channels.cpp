// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectral_channels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "text_lines.h"

namespace nacre::spectral {
namespace {

constexpr double kLightSpeed = 299'792'458.0;  ///< m/s, exact (SI)

/// What a prefix of the SI multiplies by; nothing for a text that is none.
std::optional<double> si_factor(std::string_view prefix)
{
    constexpr std::array<std::pair<std::string_view, double>, 21> kPrefixes = {
        {{"", 1.0},    {"Y", 1e24},  {"Z", 1e21}, {"E", 1e18}, {"P", 1e15},  {"T", 1e12},
         {"G", 1e9},   {"M", 1e6},   {"k", 1e3},  {"h", 1e2},  {"da", 1e1},  {"d", 1e-1},
         {"c", 1e-2},  {"m", 1e-3},  {"u", 1e-6}, {"n", 1e-9}, {"p", 1e-12}, {"f", 1e-15},
         {"a", 1e-18}, {"z", 1e-21}, {"y", 1e-24}}};
    const auto* found =
        std::ranges::find(kPrefixes, prefix, &decltype(kPrefixes)::value_type::first);
    if (found == kPrefixes.end()) return std::nullopt;
    return found->second;
}

bool cut_end(std::string_view& text, std::string_view end)
{
    if (!text.ends_with(end)) return false;
    text.remove_suffix(end.size());
    return true;
}

/// `550,000000nm` or `545THz` in nm.
std::optional<double> parse_wavelength(std::string_view text)
{
    constexpr std::string_view kNumber = "0123456789,.+-eE";
    const std::size_t unit_at = std::min(text.find_first_not_of(kNumber), text.size());
    // The E of exa is one of a number as well.
    std::string number(text.substr(0, unit_at));
    std::string_view unit = text.substr(unit_at);
    std::optional<double> exa;
    if (number.ends_with('E')) {
        number.pop_back();
        exa = 1e18;
    }
    std::ranges::replace(number, ',', '.');
    const auto value = parse_number(number);
    const bool frequency = cut_end(unit, "Hz");
    if (!frequency && !cut_end(unit, "m")) return std::nullopt;
    if (exa && !unit.empty()) return std::nullopt;
    const auto factor = exa ? exa : si_factor(unit);
    if (!value || !factor) return std::nullopt;
    const double metres = frequency ? kLightSpeed / (*value * *factor) : *value * *factor;
    const double nm = metres * 1e9;
    if (!std::isfinite(nm) || !(nm > 0.0)) return std::nullopt;
    return nm;
}

}  // namespace

std::optional<SpectralChannel> parse_spectral_channel(std::string_view name)
{
    const bool emission = name.starts_with("S0.");
    if (!emission && !name.starts_with("T.")) return std::nullopt;
    const auto nm = parse_wavelength(name.substr(emission ? 3 : 2));
    if (!nm) return std::nullopt;
    return SpectralChannel{emission ? SpectrumKind::emission : SpectrumKind::reflectance, *nm};
}

std::string spectral_channel_name(const SpectralChannel& channel)
{
    std::string number = fmt::format("{:.6f}", channel.wavelength_nm);
    std::ranges::replace(number, '.', ',');
    return fmt::format("{}.{}nm", channel.kind == SpectrumKind::emission ? "S0" : "T", number);
}

}  // namespace nacre::spectral
