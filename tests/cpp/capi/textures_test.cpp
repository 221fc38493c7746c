// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/textures.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

std::vector<double> ramp(std::size_t count)
{
    std::vector<double> values(count * NACRE_TEXTURE_SAMPLES);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<double>(i);
    return values;
}

TEST(CapiTextures, SpectraGoInAndComeOut)
{
    const auto values = ramp(3);
    std::vector<float> texels(std::size_t{2} * 256 * 4);
    ASSERT_EQ(nacre_pack_spectra(3, values.data(), "packed", 2, texels.data()), NACRE_OK);
    EXPECT_EQ(texels[std::size_t{256} * 4 + 5], 1024.0F + 5) << "the third starts the second row";
    const nacre_texture texture{256, 2, 4, texels.data()};
    std::vector<double> read(values.size());
    ASSERT_EQ(nacre_unpack_spectra(&texture, "packed", 2, 3, read.data()), NACRE_OK);
    EXPECT_EQ(read, values);
    EXPECT_EQ(nacre_unpack_spectra(&texture, "single", 2, 3, read.data()), NACRE_INPUT);
    EXPECT_EQ(nacre_pack_spectra(3, values.data(), "tight", 2, texels.data()), NACRE_INPUT);
    EXPECT_STREQ(nacre_last_error(), "layout: must be packed or single (got tight)");
    EXPECT_EQ(nacre_pack_spectra(3, nullptr, "packed", 2, texels.data()), NACRE_INPUT);
}

TEST(CapiTextures, MaterialsAndLights)
{
    const auto values = ramp(2);
    const std::vector<double> colours = {1, 0.5, 0.25, 0, 0, 1};
    std::vector<float> texels(std::size_t{2} * NACRE_MATERIAL_TEXELS * 4);
    ASSERT_EQ(nacre_pack_materials(2, values.data(), values.data(), values.data(), colours.data(),
                                   1, texels.data()),
              NACRE_OK);
    EXPECT_EQ(texels[std::size_t{513} * 4 + 1], 511.0F) << "largest n of the first";
    const nacre_texture materials{NACRE_MATERIAL_TEXELS, 2, 4, texels.data()};
    std::vector<double> intensity(values.size()), n(values.size()), k(values.size()), rgb(6);
    ASSERT_EQ(nacre_unpack_materials(&materials, intensity.data(), n.data(), k.data(), rgb.data()),
              NACRE_OK);
    EXPECT_EQ(intensity, values);
    EXPECT_NEAR(n[700], 700.0, 1e-3);
    EXPECT_EQ(rgb, colours);

    ASSERT_EQ(nacre_pack_lights(2, values.data(), colours.data(), texels.data()), NACRE_OK);
    const nacre_texture lights{NACRE_MATERIAL_TEXELS, 1, 4, texels.data()};
    ASSERT_EQ(nacre_unpack_lights(&lights, 2, intensity.data(), rgb.data()), NACRE_OK);
    EXPECT_EQ(intensity, values);
    EXPECT_EQ(rgb, colours);
    EXPECT_EQ(nacre_unpack_lights(&lights, 5, intensity.data(), rgb.data()), NACRE_INPUT);
}

TEST(CapiTextures, SamplesOfASpectrum)
{
    const std::vector<double> wavelengths = {400, 600}, values = {0, 1};
    std::vector<double> samples(NACRE_TEXTURE_SAMPLES);
    ASSERT_EQ(nacre_texture_samples(2, wavelengths.data(), values.data(), 1, samples.data()),
              NACRE_OK);
    EXPECT_EQ(samples[500 - 324], 0.5);
    EXPECT_EQ(samples[0], 0.0);
    EXPECT_EQ(samples[511], 1.0);
}

TEST(CapiTextures, TextBothWays)
{
    const std::vector<float> texels = {0.25F, 1e-7F};
    const nacre_texture grey{1, 2, 1, texels.data()};
    const char* const keys[] = {"made by"};
    const char* const values[] = {"hand"};
    nacre_ftxt* written = nullptr;
    ASSERT_EQ(nacre_write_ftxt(&grey, 1, keys, values, &written), NACRE_OK);
    const std::string text = nacre_ftxt_text(written);
    EXPECT_EQ(text, "# made by: hand\n1;2\n0.25;0.25;0.25;1\n1e-07;1e-07;1e-07;1\n");
    nacre_ftxt_free(written);

    nacre_ftxt* read = nullptr;
    ASSERT_EQ(nacre_read_ftxt(text.data(), text.size(), "grey.ftxt", &read), NACRE_OK);
    nacre_texture texture{};
    ASSERT_EQ(nacre_ftxt_texture(read, &texture), NACRE_OK);
    EXPECT_EQ(texture.height, 2);
    EXPECT_EQ(texture.channels, 4);
    EXPECT_EQ(texture.texels[4], 1e-7F);
    ASSERT_EQ(nacre_ftxt_comments(read), 1U);
    EXPECT_STREQ(nacre_ftxt_key(read, 0), "made by");
    EXPECT_STREQ(nacre_ftxt_value(read, 0), "hand");
    EXPECT_EQ(nacre_ftxt_key(read, 1), nullptr);
    nacre_ftxt_free(read);
    EXPECT_EQ(nacre_read_ftxt("1;1\n", 4, "grey.ftxt", &read), NACRE_INPUT);
    EXPECT_STREQ(nacre_last_error(), "grey.ftxt:1: texel: must be as many as 1 x 1 = 1 (got 0)");
}

}  // namespace
