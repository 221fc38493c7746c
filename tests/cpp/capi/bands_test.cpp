// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/bands.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <numeric>
#include <vector>

#include "refusal.h"

namespace {

using nacre::test::error;

constexpr std::array<double, 3> kLaserNm = {462, 532, 638}, kLaserPower = {1, 0.8, 1.2};
constexpr std::array<double, 3> kSampleNm = {400, 550, 700}, kSamplePower = {1, 2, 1};

nacre_light named(const char* name)
{
    nacre_light light{};
    light.name = name;
    return light;
}

nacre_light lasers()
{
    nacre_light light{};
    light.lines = 3;
    light.line_nm = kLaserNm.data();
    light.line_power = kLaserPower.data();
    return light;
}

nacre_light samples()
{
    nacre_light light{};
    light.count = 3;
    light.wavelength_nm = kSampleNm.data();
    light.power = kSamplePower.data();
    return light;
}

struct Free {
    void operator()(nacre_bands* bands) const { nacre_bands_free(bands); }
};
using Handle = std::unique_ptr<nacre_bands, Free>;

Handle made(std::size_t count, const std::vector<nacre_light>& lights)
{
    nacre_bands* bands = nullptr;
    EXPECT_EQ(nacre_bands_make(count, lights.size(), lights.data(), "cie1931", &bands), NACRE_OK)
        << nacre_last_error();
    return Handle(bands);
}

TEST(CapiBands, TellWhatTheyAre)
{
    const Handle bands = made(12, {named("D65"), lasers()});
    ASSERT_EQ(nacre_bands_count(bands.get()), 12u);
    std::array<double, 13> edges{};
    std::array<double, 12> nm{};
    std::array<double, 36> xyz{};
    std::array<unsigned char, 12> is_line{};
    ASSERT_EQ(nacre_bands_get(bands.get(), edges.data(), nm.data(), xyz.data(), is_line.data()),
              NACRE_OK);
    EXPECT_EQ(edges.front(), 360.0);
    EXPECT_NEAR(edges.back(), 830.0, 1e-9);
    double luminance = 0.0;
    std::vector<double> lines;
    for (std::size_t k = 0; k < 12; ++k) {
        EXPECT_TRUE(edges[k] < nm[k] && nm[k] < edges[k + 1]);
        luminance += xyz[3 * k + 1];
        if (is_line[k] != 0) lines.push_back(nm[k]);
    }
    EXPECT_NEAR(luminance, 1.0, 1e-4);
    EXPECT_EQ(lines, std::vector(kLaserNm.begin(), kLaserNm.end()));
    EXPECT_EQ(nacre_bands_get(bands.get(), edges.data(), nm.data(), xyz.data(), nullptr), NACRE_OK);
    EXPECT_EQ(nacre_bands_count(nullptr), 0u);
    nacre_bands_free(nullptr);
}

TEST(CapiBands, TakeLightsByNameSamplesAndLines)
{
    nacre_light both = samples();
    both.lines = 1;
    both.line_nm = kLaserNm.data();
    both.line_power = kLaserPower.data();
    const Handle bands = made(24, {named("D65"), lasers(), samples(), both});
    std::array<double, 24> power{}, more{};
    for (const nacre_light& light : {named("F11"), lasers(), samples()}) {
        ASSERT_EQ(nacre_light_in_bands(bands.get(), &light, power.data()), NACRE_OK);
        EXPECT_GT(std::accumulate(power.begin(), power.end(), 0.0), 0.0);
    }
    ASSERT_EQ(nacre_light_in_bands(bands.get(), &both, more.data()), NACRE_OK);
    int brighter = 0;
    for (std::size_t k = 0; k < 24; ++k) brighter += more[k] > power[k] ? 1 : 0;
    EXPECT_EQ(brighter, 1);  // its line
}

TEST(CapiBands, AreAsManyAsASceneNeeds)
{
    nacre_band_needs needs{};
    const nacre_light light = named("D65");
    const double film_nm = 4000.0;
    needs.lights = 1;
    needs.light = &light;
    needs.mean_error = 0.1;
    needs.max_error = 0.3;
    nacre_bands* bands = nullptr;
    nacre_band_choice choice{};
    ASSERT_EQ(nacre_bands_choose(&needs, "cie1931", &bands, &choice), NACRE_OK);
    EXPECT_EQ(nacre_bands_count(Handle(bands).get()), 24u);
    EXPECT_EQ(choice.passes, 8);
    EXPECT_EQ(choice.met, 1);
    EXPECT_STREQ(choice.held, "lights");
    EXPECT_GT(choice.max_error, choice.mean_error);

    needs.films = 1;
    needs.film_nm = &film_nm;
    ASSERT_EQ(nacre_bands_choose(&needs, "cie1964", &bands, &choice), NACRE_OK);
    EXPECT_EQ(nacre_bands_count(Handle(bands).get()), 3u * static_cast<unsigned>(choice.passes));
    EXPECT_GT(choice.passes, 16);
    EXPECT_STREQ(choice.held, "films");
    EXPECT_LE(choice.film_error, 0.1);

    const std::array<double, 3> spread = {0, 30, 60};
    needs.films = 0;
    needs.spreads = 1;
    needs.samples = 3;
    needs.wavelength_nm = kSampleNm.data();
    needs.spread_px = spread.data();
    ASSERT_EQ(nacre_bands_choose(&needs, "cie1931", &bands, &choice), NACRE_OK);
    EXPECT_EQ(nacre_bands_count(Handle(bands).get()), 3u * static_cast<unsigned>(choice.passes));
    EXPECT_STREQ(choice.held, "spreads");
}

TEST(CapiBands, SayHowFarColoursAreOff)
{
    const Handle few = made(6, {named("D65")}), many = made(60, {named("D65")});
    const nacre_light light = named("D65");
    const std::array<double, 6> reflectances = {0.1, 0.9, 0.2, 0.8, 0.1, 0.7};
    std::array<double, 2> mean{}, largest{};
    const std::array<const nacre_bands*, 2> both = {few.get(), many.get()};
    for (std::size_t i = 0; i < 2; ++i)
        ASSERT_EQ(nacre_band_error(both[i], &light, 3, kSampleNm.data(), 2, reflectances.data(),
                                   &mean[i], &largest[i]),
                  NACRE_OK);
    EXPECT_GT(mean[0], 10.0 * mean[1]);
    EXPECT_GE(largest[0], mean[0]);
    EXPECT_EQ(error(nacre_band_error(few.get(), &light, 3, kSampleNm.data(), 0, reflectances.data(),
                                     mean.data(), largest.data())),
              "reflectances: must be one or more");
}

TEST(CapiBands, RefuseWhatIsNoLight)
{
    nacre_bands* bands = nullptr;
    const auto refused = [&bands](nacre_light light) {
        return error(nacre_bands_make(12, 1, &light, "cie1931", &bands));
    };
    EXPECT_NE(refused(named("candle")).find("candle"), std::string::npos);
    EXPECT_NE(refused(named(nullptr)).find("name: must not be null"), std::string::npos);
    nacre_light light = lasers();
    const double negative = -1.0, far = 900.0;
    light.lines = 1;
    light.line_power = &negative;
    EXPECT_NE(refused(light).find("power"), std::string::npos);
    light = lasers();
    light.lines = 1;
    light.line_nm = &far;
    EXPECT_NE(refused(light).find("900"), std::string::npos);
    light = samples();
    const std::array<double, 3> below = {1, -1, 1};
    light.power = below.data();
    EXPECT_NE(refused(light).find("power"), std::string::npos);
    EXPECT_NE(error(nacre_bands_make(1000, 0, nullptr, "cie1931", &bands)).find("300"),
              std::string::npos);
    EXPECT_NE(error(nacre_bands_make(12, 0, nullptr, "cie2006", &bands)).find("cie2006"),
              std::string::npos);
    EXPECT_EQ(bands, nullptr);

    nacre_band_needs needs{};
    nacre_band_choice choice{};
    EXPECT_NE(error(nacre_bands_choose(&needs, "cie1931", &bands, &choice)).find("must be > 0"),
              std::string::npos);
    needs.mean_error = needs.max_error = 0.1;
    EXPECT_NE(error(nacre_bands_choose(&needs, "cie1931", &bands, &choice)).find("lights"),
              std::string::npos);
}

}  // namespace
