// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "nacre/media/working_range.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/named_spectrum.h"
#include "nacre/textures/texture.h"

/// @file
/// Spectra in textures: one fetch gives a shader several wavelengths, or all that a wavelength
/// needs.

namespace nacre::spectral {

inline constexpr int kTextureFirstNm = 324;
inline constexpr std::size_t kTextureSamples = 512;  ///< 324 … 835 nm, every 1 nm

/// Sample i belongs to 324 + i nm.
using TextureSamples = std::array<double, kTextureSamples>;

[[nodiscard]] constexpr double texture_wavelength_nm(std::size_t i) noexcept
{
    return kTextureFirstNm + static_cast<double>(i);
}

/// As NamedSpectrum::values_at() has it.
/// @throws InputError when the spectrum does not overlap 324 … 835 nm
[[nodiscard]] TextureSamples texture_samples(const NamedSpectrum& spectrum);

// ---- Many spectra, nothing else --------------------------------------------------------------

enum class SpectrumLayout {
    packed,  ///< RGBA: texel i of 128 holds 324 + 4 i nm and the three after it
    single,  ///< one channel: texel i of 512 holds 324 + i nm
};

[[nodiscard]] std::size_t texels_per_spectrum(SpectrumLayout layout) noexcept;

/// Spectrum s starts at texel (s mod columns) × texels_per_spectrum() of row s / columns; what is
/// left of the last row is 0.
/// @throws InputError when there is no spectrum or no column, or a side exceeds kMaxTextureSide
[[nodiscard]] Texture pack_spectra(std::span<const TextureSamples> spectra, SpectrumLayout layout,
                                   std::size_t columns);

/// @throws InputError when the texture has too few channels or texels for them
[[nodiscard]] std::vector<TextureSamples> unpack_spectra(const Texture& texture,
                                                         SpectrumLayout layout, std::size_t columns,
                                                         std::size_t count);

// ---- All that a wavelength needs of a material ------------------------------------------------

/// Behind the 512 texels of a row: colours, limits.
inline constexpr std::size_t kTrailingTexels = 4;
inline constexpr std::size_t kMaterialTexels = kTextureSamples + kTrailingTexels;

struct MaterialSpectra {
    TextureSamples intensity, n, k;
    Vec3 colour;  ///< what the intensity comes to, linear
};

/// Intensity: the reflectance in air at normal incidence; colour: of it, by `weights`.
/// By the rule over 360 … 830 nm; what a texture has beyond is held where the data end.
/// @throws InputError where the rule refuses the medium
[[nodiscard]] MaterialSpectra material_spectra(const Medium& medium, const ColourWeights& weights,
                                               RangeRule rule);

/// A row each, RGBA. Texel i < 512: intensity, n and k at 324 + i nm, 1. With `normalise` n and k
/// are stored as (v − min) / (max − min), 0 where both are the same. Texel 512: the colour, 1.
/// Texel 513: n min, n max, k min, k max (0, 1, 0, 1 without `normalise`). Texels 514, 515: 0.
/// @throws InputError when there is none, or more than kMaxTextureSide
[[nodiscard]] Texture pack_materials(std::span<const MaterialSpectra> materials, bool normalise);
/// @throws InputError when the texture is not one of materials
[[nodiscard]] std::vector<MaterialSpectra> unpack_materials(const Texture& texture);

struct LightSpectra {
    TextureSamples power;
    Vec3 colour;
};

/// Rows of the same width, four lights in each: R, G, B and A of texel i < 512 hold their power at
/// 324 + i nm; texel 512 + j the colour of the light in channel j, 1. Where there is no light: 0.
/// @throws InputError when there is none, or more than 4 × kMaxTextureSide
[[nodiscard]] Texture pack_lights(std::span<const LightSpectra> lights);
/// @throws InputError when the texture does not hold `count` lights
[[nodiscard]] std::vector<LightSpectra> unpack_lights(const Texture& texture, std::size_t count);

}  // namespace nacre::spectral
