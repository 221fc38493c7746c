// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/textures/spectral_channels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "nacre/core/text_lines.h"

namespace nacre::spectral {
namespace {

constexpr double kLightSpeed = 299'792'458.0;  ///< m/s, exact (SI)

/// Power of ten of a prefix of the SI; nothing for a text that is none.
std::optional<int> si_exponent(std::string_view prefix)
{
    constexpr std::array<std::pair<std::string_view, int>, 21> kPrefixes = {
        {{"", 0},   {"Y", 24}, {"Z", 21},  {"E", 18},  {"P", 15},  {"T", 12},  {"G", 9},
         {"M", 6},  {"k", 3},  {"h", 2},   {"da", 1},  {"d", -1},  {"c", -2},  {"m", -3},
         {"u", -6}, {"n", -9}, {"p", -12}, {"f", -15}, {"a", -18}, {"z", -21}, {"y", -24}}};
    for (const auto& [name, exponent] : kPrefixes)
        if (name == prefix) return exponent;
    return std::nullopt;
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
    std::string number(text.substr(0, unit_at));
    std::string_view unit = text.substr(unit_at);
    // The E of exa is one of a number as well.
    const bool exa = number.ends_with('E');
    if (exa) number.pop_back();
    std::ranges::replace(number, ',', '.');
    const bool frequency = cut_end(unit, "Hz");
    if (!frequency && !cut_end(unit, "m")) return std::nullopt;
    if (exa && !unit.empty()) return std::nullopt;
    const auto exponent = si_exponent(exa ? "E" : unit);
    const auto value = parse_number(number);
    if (!value || !exponent) return std::nullopt;
    constexpr int kNano = 9;  // in powers of ten, so that nm stay as they are
    const double nm = frequency ? kLightSpeed / (*value * std::pow(10.0, *exponent - kNano))
                                : *value * std::pow(10.0, *exponent + kNano);
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
