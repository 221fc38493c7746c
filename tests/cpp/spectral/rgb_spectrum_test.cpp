// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/rgb_spectrum.h"
#include "nacre/library/lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/expect.h"

namespace nacre::spectral {
namespace {

class Draw {
public:
    Vec3 colour() { return {number(), number(), number()}; }
    double number() { return static_cast<double>(engine_()) / 4294967296.0; }

private:
    std::mt19937 engine_{19};
};

TEST(RgbSpectrum, EveryColourOfRec709IsMet)
{
    Draw draw;
    for (int i = 0; i < 2000; ++i) {
        Vec3 rgb = draw.colour();
        // Every other one dark, and faces and edges of the cube now and then.
        if (i % 2 == 0)
            for (double& value : rgb) value *= 0.001;
        if (i % 5 == 0) rgb[0] = 0.0;
        if (i % 7 == 0) rgb[1] = i % 2 == 0 ? 0.0 : 1.0;
        const Sampled values = sigmoid_spectrum(rgb).on_grid();
        EXPECT_LE(round_trip_error(rgb, values), 1e-6) << rgb[0] << ' ' << rgb[1] << ' ' << rgb[2];
        EXPECT_GE(std::ranges::min(values), 0.0);
        EXPECT_LE(std::ranges::max(values), 1.0);
    }
}

TEST(RgbSpectrum, CornersAreMet)
{
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 rgb = {corner & 1 ? 1.0 : 0.0, corner & 2 ? 1.0 : 0.0, corner & 4 ? 1.0 : 0.0};
        EXPECT_LE(round_trip_error(rgb, sigmoid_spectrum(rgb).on_grid()), 1e-6) << corner;
    }
    // Close to white the coefficients go to infinity.
    for (const double step : {1e-3, 1e-5, 1e-7, 1e-12})
        EXPECT_LE(round_trip_error({1.0, 1.0, 1.0 - step},
                                   sigmoid_spectrum({1.0, 1.0, 1.0 - step}).on_grid()),
                  0.01)
            << step;
}

TEST(RgbSpectrum, GreyIsConstant)
{
    for (const double grey : {0.0, 1e-9, 0.2, 0.5, 1.0}) {
        const SigmoidSpectrum spectrum = sigmoid_spectrum({grey, grey, grey});
        EXPECT_NEAR(spectrum.at(400.0), grey, 1e-15);
        EXPECT_EQ(spectrum.at(400.0), spectrum.at(700.0));
    }
}

TEST(RgbSpectrum, TableAloneIsClose)
{
    Draw draw;
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 rgb = draw.colour();
        const double error = round_trip_error(rgb, read_sigmoid_table(rgb).on_grid());
        sum += error;
        largest = std::max(largest, error);
    }
    EXPECT_LE(sum / 2000, 0.2);
    EXPECT_LE(largest, 3.5);
}

TEST(RgbSpectrum, PolynomialOfNanometresIsTheSame)
{
    const SigmoidSpectrum spectrum = sigmoid_spectrum({0.7, 0.2, 0.05});
    const Vec3 c = spectrum.by_nanometre();
    for (const double nm : {360.0, 500.0, 830.0}) {
        const double x = (c[0] * nm + c[1]) * nm + c[2];
        EXPECT_NEAR(0.5 + 0.5 * x / std::sqrt(1.0 + x * x), spectrum.at(nm), 1e-12);
    }
}

TEST(RgbSpectrum, WiderSpacesAsFarAsReflectancesGo)
{
    const Mat3& to_xyz = colour_space("lin_rec2020_scene").to_xyz_d65;
    const Mat3& from_xyz = colour_space("lin_rec709_scene").from_xyz_d65;
    const auto to_709 = [&](const Vec3& wide) {
        Vec3 xyz{}, rgb{};
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) xyz[a] += to_xyz[a][b] * wide[b];
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b) rgb[a] += from_xyz[a][b] * xyz[b];
        return rgb;
    };
    const Vec3 vivid = to_709({0.1, 0.4, 0.05});
    EXPECT_LT(std::ranges::min(vivid), 0.0);
    EXPECT_LE(round_trip_error(vivid, sigmoid_spectrum(vivid).on_grid()), 1e-6);
    // Its primaries are single wavelengths: no reflectance has them at full strength.
    EXPECT_INPUT_ERROR((void)sigmoid_spectrum(to_709({0.0, 1.0, 0.0})), "nearest found");
}

TEST(RgbSpectrum, WrongColoursAreRefused)
{
    EXPECT_INPUT_ERROR((void)sigmoid_spectrum({1.2, 1.2, 1.2}), "nearest found");
    EXPECT_INPUT_ERROR((void)sigmoid_spectrum({std::numeric_limits<double>::quiet_NaN(), 0, 0}),
                       "finite");
    EXPECT_INPUT_ERROR((void)smits_spectrum({0.2, -0.1, 0.5}), "must be in [0, 1]");
}

TEST(RgbSpectrum, SmitsByHand)
{
    // White 0.1, yellow 0.2 (blue is the least), red 0.3; in the first and the last bin.
    const Sampled values = smits_spectrum({0.6, 0.3, 0.1});
    EXPECT_NEAR(values[380 - kFirstNm], 0.1 + 0.2 * 0.0001 + 0.3 * 0.1012, 1e-15);
    EXPECT_NEAR(values[719 - kFirstNm], 0.1 + 0.2 * 0.9840 + 0.3 * 1.0149, 1e-15);
    EXPECT_EQ(values[0], values[380 - kFirstNm]);
    EXPECT_EQ(values[kWavelengths - 1], values[719 - kFirstNm]);
    EXPECT_NE(values[413 - kFirstNm], values[414 - kFirstNm]);
}

TEST(RgbSpectrum, SmitsRoundTripIsOffUnderD65)
{
    const ColourWeights weights =
        reflectance_weights(named_illuminant("D65"), ObserverId::cie1931,
                            colour_space("lin_rec709_scene"), Adaptation::bradford);
    Draw draw;
    double largest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 rgb = draw.colour();
        const Vec3 back = weights.apply(smits_spectrum(rgb));
        for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(back[c] - rgb[c]));
    }
    EXPECT_GT(largest, 0.02);
    EXPECT_LT(largest, 0.12);
}

TEST(RgbSpectrum, LightsAreD65ThroughAFilter)
{
    const ColourSpace& space = colour_space("lin_rec709_scene");
    const RisenSpectrum white =
        rgb_to_spectrum({7.0, 7.0, 7.0}, space, Upsampling::sigmoid, SpectrumKind::emission);
    EXPECT_NEAR(emission_to_xyz(white.values, ObserverId::cie1931)[1], 7.0, 1e-12);
    const Sampled d65 = named_illuminant("D65").power;
    for (const std::size_t i : {0, 100, 300})
        EXPECT_NEAR(white.values[i] / d65[i], white.values[200] / d65[200], 1e-15);
    EXPECT_TRUE(white.coefficients);
    const RisenSpectrum black =
        rgb_to_spectrum({0.0, 0.0, 0.0}, space, Upsampling::smits, SpectrumKind::emission);
    EXPECT_EQ(std::ranges::max(black.values), 0.0);
    EXPECT_FALSE(black.coefficients);
}

TEST(RgbSpectrum, NamesAndSpacesAreRead)
{
    EXPECT_EQ(upsampling_from_name("smits"), Upsampling::smits);
    EXPECT_INPUT_ERROR((void)upsampling_from_name("meng"), "jakob-hanika or smits");
    EXPECT_INPUT_ERROR((void)rgb_to_spectrum({0.1, 0.2, 0.3}, colour_space("xyz_d65"),
                                             Upsampling::sigmoid, SpectrumKind::reflectance),
                       "must be an RGB space");
}

}  // namespace
}  // namespace nacre::spectral
