// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/textures/spectrum_texture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::spectral {
namespace {

TextureSamples ramp(double scale)
{
    TextureSamples samples;
    for (std::size_t i = 0; i < kTextureSamples; ++i) samples[i] = scale * static_cast<double>(i);
    return samples;
}

std::string message_of(auto&& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(SpectrumTexture, FourWavelengthsATexelFrom324)
{
    const std::vector<TextureSamples> spectra = {ramp(1), ramp(2), ramp(3)};
    const Texture texture = pack_spectra(spectra, SpectrumLayout::packed, 2);
    ASSERT_EQ(texture.width, 256);
    ASSERT_EQ(texture.height, 2);
    ASSERT_EQ(texture.channels, 4);
    // Texel i of spectrum (column, row): λ1 = 324 + 4 i.
    const float* texel = texture.at(128 + 59, 0);
    EXPECT_EQ(texel[0], 2.0F * 4 * 59);
    EXPECT_EQ(texel[3], 2.0F * (4 * 59 + 3));
    EXPECT_EQ(texture_wavelength_nm(4 * 59), 560.0);
    EXPECT_EQ(texture.at(127, 1)[3], 3.0F * 511);
    EXPECT_EQ(texture.at(128 + 59, 1)[0], 0.0F) << "nothing there";
}

TEST(SpectrumTexture, OneSampleATexel)
{
    const std::vector<TextureSamples> spectra = {ramp(1), ramp(2)};
    const Texture texture = pack_spectra(spectra, SpectrumLayout::single, 1);
    EXPECT_EQ(texture.width, 512);
    EXPECT_EQ(texture.height, 2);
    EXPECT_EQ(texture.channels, 1);
    EXPECT_EQ(*texture.at(236, 1), 472.0F);
}

TEST(SpectrumTexture, UnpacksWhatItPacked)
{
    const std::vector<TextureSamples> spectra = {ramp(1), ramp(0.25), ramp(2), ramp(8), ramp(16)};
    for (const auto layout : {SpectrumLayout::packed, SpectrumLayout::single})
        for (const std::size_t columns : {1, 2, 5, 7}) {
            const Texture texture = pack_spectra(spectra, layout, columns);
            EXPECT_EQ(unpack_spectra(texture, layout, columns, 5), spectra) << columns;
        }
}

TEST(SpectrumTexture, RefusesWhatDoesNotFit)
{
    const std::vector<TextureSamples> one = {ramp(1)};
    EXPECT_NE(message_of([&] { (void)pack_spectra({}, SpectrumLayout::packed, 1); }).find("0"),
              std::string::npos);
    for (const std::size_t columns : {std::size_t{0}, std::size_t{513}, ~std::size_t{0}})
        EXPECT_NE(message_of([&] {
                      (void)pack_spectra(one, SpectrumLayout::packed, columns);
                  }).find("sides in [1, 65536]"),
                  std::string::npos)
            << columns;
    const Texture texture = pack_spectra(one, SpectrumLayout::packed, 1);
    EXPECT_NE(message_of([&] {
                  (void)unpack_spectra(texture, SpectrumLayout::packed, 1, 2);
              }).find("must be 128 texels wide and 2 high"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  (void)unpack_spectra(texture, SpectrumLayout::single, 1, 1);
              }).find("got 128 x 1"),
              std::string::npos);
    EXPECT_NE(message_of([&] { (void)unpack_materials(texture); }).find("516 texels"),
              std::string::npos);
}

TEST(SpectrumTexture, SamplesOfTheLibraryAndOfLights)
{
    const NamedSpectrum& patch = library_spectrum("colorchecker/dark-skin");
    const TextureSamples samples = texture_samples(patch);
    const Sampled grid = patch.on_grid();
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_EQ(samples[i + 36], grid[i]);
    EXPECT_EQ(samples[0], patch.samples.values().front());

    const TextureSamples light = texture_samples(light_spectrum("D65"));
    EXPECT_EQ(light[236], 100.0);
    // ISO/CIE 11664-2:2022: 20.2360 at 320, 28.6447 at 325, 46.6383 at 360 nm.
    EXPECT_NEAR(light[0], 20.236 + 0.8 * (28.6447 - 20.236), 1e-12);
    EXPECT_EQ(light[511], named_illuminant("D65").power.back());
}

TEST(SpectrumTexture, MaterialsNormalisedAndNot)
{
    const auto weights = reflectance_weights(named_illuminant("D65"), ObserverId::cie1931,
                                             colour_space("lin_rec709_scene"));
    const std::vector<MaterialSpectra> metals = {
        material_spectra(library_medium("Au/Johnson"), weights, RangeRule::strict),
        material_spectra(library_medium("air"), weights, RangeRule::strict)};
    EXPECT_EQ(metals[1].colour, (Vec3{0.0, 0.0, 0.0}));
    // Johnson and Christy 1972 at 2.26 eV, 548.6 nm: 0.43 + 2.455 i.
    EXPECT_NEAR(metals[0].n[225], 0.43, 0.002);
    EXPECT_NEAR(metals[0].k[225], 2.455, 0.005);
    EXPECT_GT(metals[0].colour[0], 2.0 * metals[0].colour[2]) << "gold is yellow";
    for (const bool normalise : {true, false}) {
        const Texture texture = pack_materials(metals, normalise);
        ASSERT_EQ(texture.width, 516);
        ASSERT_EQ(texture.height, 2);
        const float* limits = texture.at(513, 0);
        const auto [lowest, highest] = std::ranges::minmax(metals[0].k);
        EXPECT_EQ(limits[2], normalise ? static_cast<float>(lowest) : 0.0F);
        EXPECT_EQ(limits[3], normalise ? static_cast<float>(highest) : 1.0F);
        for (std::size_t i = 0; normalise && i < kTextureSamples; ++i)
            for (std::size_t channel = 0; channel < 4; ++channel) {
                EXPECT_GE(texture.at(i, 0)[channel], -1e-7F);
                EXPECT_LE(texture.at(i, 0)[channel], 1.0F + 1e-6F);
            }
        const auto read = unpack_materials(texture);
        for (std::size_t row = 0; row < 2; ++row)
            for (std::size_t i = 0; i < kTextureSamples; ++i) {
                EXPECT_NEAR(read[row].n[i], metals[row].n[i], 3e-7);
                EXPECT_NEAR(read[row].k[i], metals[row].k[i], 1e-6);
                EXPECT_NEAR(read[row].intensity[i], metals[row].intensity[i], 6e-8);
            }
        EXPECT_NEAR(read[0].colour[0], metals[0].colour[0], 1e-7);
    }
}

TEST(SpectrumTexture, FourLightsARow)
{
    std::vector<LightSpectra> lights;
    for (int i = 0; i < 6; ++i) lights.push_back({ramp(i + 1), {0.1 * i, 0.5, 1.0}});
    const Texture texture = pack_lights(lights);
    EXPECT_EQ(texture.width, 516);
    EXPECT_EQ(texture.height, 2);
    EXPECT_EQ(texture.at(100, 0)[3], 400.0F);
    EXPECT_EQ(texture.at(100, 1)[1], 600.0F);
    EXPECT_EQ(texture.at(100, 1)[2], 0.0F) << "no seventh light";
    EXPECT_EQ(texture.at(514, 0)[0], 0.2F) << "colour of the light in B";
    const auto read = unpack_lights(texture, 6);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(read[i].power, lights[i].power);
    EXPECT_NE(message_of([&] { (void)unpack_lights(texture, 9); }).find("3 high"),
              std::string::npos);
}

}  // namespace
}  // namespace nacre::spectral
