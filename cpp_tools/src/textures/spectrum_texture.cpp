// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/textures/spectrum_texture.h"

#include <algorithm>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {
namespace {

constexpr std::size_t kPacked = 4;  ///< samples a texel

TextureSamples texture_wavelengths() noexcept
{
    TextureSamples wavelengths;
    for (std::size_t i = 0; i < kTextureSamples; ++i) wavelengths[i] = texture_wavelength_nm(i);
    return wavelengths;
}

/// @throws InputError unless first ≤ 835 and last ≥ 324
void require_overlap(double first_nm, double last_nm)
{
    const double end = texture_wavelength_nm(kTextureSamples - 1);
    if (first_nm <= end && last_nm >= kTextureFirstNm) return;
    throw InputError({{},
                      0,
                      "wavelength_nm",
                      fmt::format("must overlap {} … {} nm (got {} … {})", kTextureFirstNm, end,
                                  first_nm, last_nm)});
}

/// All 0. @throws InputError where it would be empty or too large
Texture blank(std::size_t width, std::size_t height, std::size_t channels, const char* what)
{
    constexpr std::size_t kMost = kMaxTextureSide;
    if (width == 0 || height == 0 || width > kMost || height > kMost)
        throw InputError({{},
                          0,
                          what,
                          fmt::format("must fill a texture with sides in [1, {}] (got {} x {})",
                                      kMost, width, height)});
    return {.width = static_cast<int>(width),
            .height = static_cast<int>(height),
            .channels = static_cast<int>(channels),
            .texels = std::vector<float>(width * height * channels)};
}

void require_size(const Texture& texture, std::size_t width, std::size_t height,
                  std::size_t channels, const char* what)
{
    const auto number = [](std::size_t side) { return static_cast<int>(side); };
    if (texture.width == number(width) && texture.height >= number(height) &&
        texture.channels >= number(channels))
        return;
    throw InputError(
        {{},
         0,
         "texture",
         fmt::format("must be {} texels wide and {} high with {} channels for {} (got {} x {}, {})",
                     width, height, channels, what, texture.width, texture.height,
                     texture.channels)});
}

struct Limits {
    double min, max;

    [[nodiscard]] double span() const noexcept { return max > min ? max - min : 1.0; }
};

Limits limits_of(const TextureSamples& values, bool normalise)
{
    if (!normalise) return {0.0, 1.0};
    const auto [min, max] = std::ranges::minmax(values);
    // What is stored is what a reader multiplies by.
    return {static_cast<float>(min), static_cast<float>(max)};
}

void store(float* texel, const Vec3& colour)
{
    std::ranges::transform(colour, texel, [](double v) { return static_cast<float>(v); });
    texel[3] = 1.0F;
}

Vec3 load_colour(const float* texel)
{
    return {texel[0], texel[1], texel[2]};
}

}  // namespace

TextureSamples texture_samples(const NamedSpectrum& spectrum)
{
    require_overlap(spectrum.samples.first_nm(), spectrum.samples.last_nm());
    TextureSamples samples;
    std::ranges::copy(spectrum.values_at(texture_wavelengths()), samples.begin());
    return samples;
}

std::size_t texels_per_spectrum(SpectrumLayout layout) noexcept
{
    return layout == SpectrumLayout::packed ? kTextureSamples / kPacked : kTextureSamples;
}

Texture pack_spectra(std::span<const TextureSamples> spectra, SpectrumLayout layout,
                     std::size_t columns)
{
    // More columns than fit have a width that is refused, too large a number wraps around without.
    columns = std::min<std::size_t>(columns, kMaxTextureSide + 1);
    const std::size_t rows = columns == 0 ? 0 : (spectra.size() + columns - 1) / columns;
    const std::size_t texels = texels_per_spectrum(layout);
    const std::size_t channels = kTextureSamples / texels;
    Texture texture = blank(columns * texels, rows, channels, "spectra");
    for (std::size_t s = 0; s < spectra.size(); ++s) {
        float* first = texture.at(s % columns * texels, s / columns);
        std::ranges::transform(spectra[s], first, [](double v) { return static_cast<float>(v); });
    }
    return texture;
}

std::vector<TextureSamples> unpack_spectra(const Texture& texture, SpectrumLayout layout,
                                           std::size_t columns, std::size_t count)
{
    const std::size_t texels = texels_per_spectrum(layout);
    if (columns == 0 || columns > kMaxTextureSide)
        throw InputError(
            {{},
             0,
             "columns",
             fmt::format("must be in [1, {}] (got {})", kMaxTextureSide / texels, columns)});
    const std::size_t wanted = kTextureSamples / texels;
    const std::size_t rows = count / columns + (count % columns == 0 ? 0 : 1);
    require_size(texture, columns * texels, rows, wanted,
                 layout == SpectrumLayout::packed ? "packed spectra" : "single spectra");
    std::vector<TextureSamples> spectra(count);
    for (std::size_t s = 0; s < count; ++s)
        for (std::size_t i = 0; i < kTextureSamples; ++i)
            spectra[s][i] = texture.at(s % columns * texels + i / wanted, s / columns)[i % wanted];
    return spectra;
}

MaterialSpectra material_spectra(const Medium& medium, const ColourWeights& weights, RangeRule rule)
{
    const OpticalConstantsPtr constants = WorkingRange(rule).cover(medium.constants);
    const auto [first, last] = constants->range_nm();
    MaterialSpectra material;
    for (std::size_t i = 0; i < kTextureSamples; ++i) {
        const Complex index = constants->at(std::clamp(texture_wavelength_nm(i), first, last));
        material.n[i] = index.real();
        material.k[i] = index.imag();
        // Fresnel at normal incidence, from air.
        material.intensity[i] = std::norm((index - 1.0) / (index + 1.0));
    }
    Sampled on_grid;
    std::copy_n(material.intensity.begin() + (kFirstNm - kTextureFirstNm), kWavelengths,
                on_grid.begin());
    material.colour = weights.apply(on_grid);
    return material;
}

Texture pack_materials(std::span<const MaterialSpectra> materials, bool normalise)
{
    Texture texture = blank(kMaterialTexels, materials.size(), 4, "materials");
    for (std::size_t row = 0; row < materials.size(); ++row) {
        const MaterialSpectra& material = materials[row];
        const Limits n = limits_of(material.n, normalise), k = limits_of(material.k, normalise);
        for (std::size_t i = 0; i < kTextureSamples; ++i)
            store(texture.at(i, row), {material.intensity[i], (material.n[i] - n.min) / n.span(),
                                       (material.k[i] - k.min) / k.span()});
        store(texture.at(kTextureSamples, row), material.colour);
        const std::array<double, 4> limits = {n.min, n.max, k.min, k.max};
        std::ranges::transform(limits, texture.at(kTextureSamples + 1, row),
                               [](double v) { return static_cast<float>(v); });
    }
    return texture;
}

std::vector<MaterialSpectra> unpack_materials(const Texture& texture)
{
    require_size(texture, kMaterialTexels, 1, 4, "materials");
    std::vector<MaterialSpectra> materials(static_cast<std::size_t>(texture.height));
    for (std::size_t row = 0; row < materials.size(); ++row) {
        MaterialSpectra& material = materials[row];
        const float* limits = texture.at(kTextureSamples + 1, row);
        const Limits n{limits[0], limits[1]}, k{limits[2], limits[3]};
        for (std::size_t i = 0; i < kTextureSamples; ++i) {
            const float* texel = texture.at(i, row);
            material.intensity[i] = texel[0];
            material.n[i] = n.min + texel[1] * n.span();
            material.k[i] = k.min + texel[2] * k.span();
        }
        material.colour = load_colour(texture.at(kTextureSamples, row));
    }
    return materials;
}

Texture pack_lights(std::span<const LightSpectra> lights)
{
    Texture texture = blank(kMaterialTexels, (lights.size() + 3) / 4, 4, "lights");
    for (std::size_t light = 0; light < lights.size(); ++light) {
        const std::size_t row = light / 4, channel = light % 4;
        for (std::size_t i = 0; i < kTextureSamples; ++i)
            texture.at(i, row)[channel] = static_cast<float>(lights[light].power[i]);
        store(texture.at(kTextureSamples + channel, row), lights[light].colour);
    }
    return texture;
}

std::vector<LightSpectra> unpack_lights(const Texture& texture, std::size_t count)
{
    require_size(texture, kMaterialTexels, count / 4 + (count % 4 == 0 ? 0 : 1), 4, "lights");
    std::vector<LightSpectra> lights(count);
    for (std::size_t light = 0; light < count; ++light) {
        const std::size_t row = light / 4, channel = light % 4;
        for (std::size_t i = 0; i < kTextureSamples; ++i)
            lights[light].power[i] = texture.at(i, row)[channel];
        lights[light].colour = load_colour(texture.at(kTextureSamples + channel, row));
    }
    return lights;
}

}  // namespace nacre::spectral
