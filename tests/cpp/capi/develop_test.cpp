// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/develop.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "refusal.h"

namespace {

using nacre::test::error;

constexpr std::size_t kCount = 24;
using PerBand = std::array<double, kCount>;

struct FreeBands {
    void operator()(nacre_bands* bands) const { nacre_bands_free(bands); }
};
using OwnedBands = std::unique_ptr<nacre_bands, FreeBands>;

class CapiDevelop : public testing::Test {
protected:
    static nacre_light light_named(const char* name)
    {
        nacre_light light{};
        light.name = name;
        return light;
    }

    OwnedBands bands_ = made();
    std::array<double, kCount + 1> edges_{};
    PerBand nm_{};
    std::array<double, 3 * kCount> xyz_{};
    std::array<unsigned char, kCount> is_line_{};

    CapiDevelop()
    {
        EXPECT_EQ(
            nacre_bands_get(bands_.get(), edges_.data(), nm_.data(), xyz_.data(), is_line_.data()),
            NACRE_OK);
    }

    static OwnedBands made()
    {
        const std::array lights = {light_named("D65"), light_named("line:532")};
        nacre_bands* bands = nullptr;
        EXPECT_EQ(nacre_bands_make(kCount, lights.size(), lights.data(), "cie1931", &bands),
                  NACRE_OK);
        return OwnedBands(bands);
    }

    PerBand power(const char* name) const
    {
        PerBand found{};
        const nacre_light light = light_named(name);
        EXPECT_EQ(nacre_light_in_bands(bands_.get(), &light, found.data()), NACRE_OK);
        return found;
    }

    std::array<double, 3> seen(const PerBand& radiance, const nacre_viewer& viewer) const
    {
        std::array<double, 3 * kCount> colours{};
        EXPECT_EQ(nacre_colours_of_bands(bands_.get(), &viewer, colours.data()), NACRE_OK)
            << nacre_last_error();
        std::array<double, 3> sum{};
        for (std::size_t k = 0; k < kCount; ++k)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += radiance[k] * colours[3 * k + c];
        return sum;
    }

    std::string refused(const nacre_viewer& viewer) const
    {
        std::array<double, 3 * kCount> colours{};
        return error(nacre_colours_of_bands(bands_.get(), &viewer, colours.data()));
    }
};

TEST_F(CapiDevelop, BandsOfAFileAreThoseThatWereWritten)
{
    nacre_bands* read = nullptr;
    ASSERT_EQ(nacre_bands_of(kCount, edges_.data(), nm_.data(), is_line_.data(), "cie1931", &read),
              NACRE_OK);
    const OwnedBands bands(read);
    std::array<double, kCount + 1> edges{};
    PerBand nm{};
    std::array<double, 3 * kCount> xyz{};
    ASSERT_EQ(nacre_bands_get(bands.get(), edges.data(), nm.data(), xyz.data(), nullptr), NACRE_OK);
    EXPECT_EQ(nm, nm_);
    for (std::size_t i = 0; i < xyz.size(); ++i) EXPECT_NEAR(xyz[i], xyz_[i], 1e-12) << i;

    ASSERT_EQ(nacre_bands_of(3, nullptr, nm_.data(), nullptr, "cie1964", &read), NACRE_OK);
    EXPECT_EQ(nacre_bands_count(OwnedBands(read).get()), 3u);
    EXPECT_NE(error(nacre_bands_of(0, nullptr, nm_.data(), nullptr, "cie1931", &read)), "");
    EXPECT_NE(error(nacre_bands_of(3, nullptr, nullptr, nullptr, "cie1931", &read))
                  .find("wavelength_nm: must not be null"),
              std::string::npos);
}

TEST_F(CapiDevelop, EyesAndCamerasSeeWhiteAsWhite)
{
    const PerBand incandescent = power("A");
    nacre_viewer viewer{};
    viewer.white = incandescent.data();
    const auto expect_white = [&] {
        const std::array<double, 3> colour = seen(incandescent, viewer);
        EXPECT_NEAR(colour[0] / colour[1], 0.3127 / 0.3290, 1e-9);
        EXPECT_NEAR(colour[2] / colour[1], 0.3583 / 0.3290, 1e-9);
    };
    expect_white();
    viewer.observer = "cie1964";
    viewer.adaptation = "cat16";
    expect_white();
    viewer.observer = nullptr;
    ASSERT_EQ(nacre_camera_count(), 2u);
    viewer.camera = nacre_camera_key(0);
    EXPECT_STREQ(viewer.camera, "nikon-d5100");
    EXPECT_EQ(nacre_camera_key(2), nullptr);
    expect_white();
    viewer.raw = 1;
    viewer.exposure = 2.0;
    const double bright = seen(incandescent, viewer)[0];
    viewer.exposure = 0.0;
    EXPECT_NEAR(bright, 4.0 * seen(incandescent, viewer)[2], 1e-9);
}

TEST_F(CapiDevelop, ACameraCanBeOnesOwn)
{
    const std::array<double, 3> nm = {400, 550, 700};
    const std::array<double, 9> sensitivity = {0, 0.2, 1, 0, 1, 0.1, 1, 0.3, 0};
    nacre_viewer viewer{};
    viewer.raw = 1;
    EXPECT_NE(refused(viewer).find("raw: is of a camera"), std::string::npos);
    viewer.samples = nm.size();
    viewer.wavelength_nm = nm.data();
    EXPECT_NE(refused(viewer).find("sensitivity: must not be null"), std::string::npos);
    viewer.sensitivity = sensitivity.data();
    const std::array<double, 3> laser = seen(power("line:532"), viewer);
    EXPECT_GT(laser[1], laser[0]);
    EXPECT_GT(laser[1], laser[2]);
    const std::array<double, 9> negative = {0, -0.2, 1, 0, 1, 0.1, 1, 0.3, 0};
    viewer.sensitivity = negative.data();
    EXPECT_NE(refused(viewer).find("sensitivity: "), std::string::npos);
}

TEST_F(CapiDevelop, ALightIsExchanged)
{
    const PerBand before = power("D65"), after = power("A");
    const nacre_light light = light_named("A");
    PerBand factors{};
    ASSERT_EQ(nacre_exchange_light(bands_.get(), before.data(), "D65", &light, factors.data()),
              NACRE_OK);
    const double scale = factors[5] * before[5] / after[5];
    for (std::size_t k = 0; k < kCount; ++k)
        EXPECT_NEAR(factors[k] * before[k], scale * after[k], 1e-9) << k;
    const PerBand laser = power("line:532");
    EXPECT_NE(
        error(nacre_exchange_light(bands_.get(), laser.data(), "Laser", &light, factors.data()))
            .find("where Laser has no light"),
        std::string::npos);
}

TEST_F(CapiDevelop, TwoPlacesAreCompared)
{
    const PerBand grey = power("D65");
    PerBand other = grey;
    other[12] *= 1.3;
    const nacre_light light = light_named("A");
    double difference = -1.0, index = -1.0;
    const auto compare = [&](const PerBand& second) {
        ASSERT_EQ(nacre_metamerism(bands_.get(), grey.data(), second.data(), grey.data(), "D65",
                                   &light, &difference, &index),
                  NACRE_OK);
    };
    compare(grey);
    EXPECT_NEAR(difference, 0.0, 1e-9);
    compare(other);
    EXPECT_GT(difference, 0.1);
    EXPECT_LT(index, difference);
}

}  // namespace
