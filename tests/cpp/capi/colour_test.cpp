// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/colour.h"
#include "refusal.h"

#include <gtest/gtest.h>
#include "support/not_numbers.h"

#include <cmath>
#include <string>
#include <vector>

namespace {

using nacre::test::error;

TEST(CapiColour, ManySpectraWithOptions)
{
    const std::vector<double> wavelength{360.0, 830.0}, values{1.0, 1.0, 0.5, 0.5};
    const nacre_colour_options options{.illuminant = "A",
                                       .observer = "cie1964",
                                       .space = "lin_ap1_scene",
                                       .adaptation = "cat16",
                                       .gamut = nullptr,
                                       .reflectance = 1};
    std::vector<nacre_colour> colours(2);
    ASSERT_EQ(
        nacre_spectra_to_colours(2, 2, wavelength.data(), values.data(), &options, colours.data()),
        NACRE_OK);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(colours[0].rgb[c], 1.0, 1e-12);
        EXPECT_NEAR(colours[1].rgb[c], 0.5, 1e-12);
    }
    EXPECT_EQ(error(nacre_spectra_to_colours(2, 2, wavelength.data(), values.data(), nullptr,
                                             colours.data())),
              "options: must not be null");
}

TEST(CapiColour, RgbToSpectrum)
{
    const std::vector<double> rgb{0.8, 0.3, 0.02, 0.5, 0.5, 0.5};
    std::vector<double> values(std::size_t{2} * NACRE_WAVELENGTHS, -7.0), coefficients(6),
        errors(2);
    ASSERT_EQ(nacre_rgb_to_spectrum(2, rgb.data(), "lin_rec709_scene", "jakob-hanika", 0,
                                    values.data(), coefficients.data(), errors.data()),
              NACRE_OK);
    EXPECT_LT(errors[0], 1e-9);
    EXPECT_NEAR(values[NACRE_WAVELENGTHS + 100], 0.5, 1e-12);
    const double x = (coefficients[0] * 600.0 + coefficients[1]) * 600.0 + coefficients[2];
    EXPECT_NEAR(values[240], 0.5 + 0.5 * x / std::sqrt(1.0 + x * x), 1e-12);

    // Nothing is written when one colour has no spectrum.
    const std::vector<double> wrong{0.5, 0.5, 0.5, 3.0, 3.0, 3.0};
    values.assign(values.size(), -7.0);
    const std::string message = error(nacre_rgb_to_spectrum(
        2, wrong.data(), "lin_rec709_scene", "jakob-hanika", 0, values.data(), nullptr, nullptr));
    EXPECT_NE(message.find("(item 1)"), std::string::npos) << message;
    EXPECT_EQ(values.front(), -7.0);
    EXPECT_EQ(error(nacre_rgb_to_spectrum(1, rgb.data(), "lin_rec709_scene", "smits", 0,
                                          values.data(), coefficients.data(), nullptr)),
              "coefficients: must be null with the method smits");
}

using nacre::test::kNan;

struct Spectrum {
    std::vector<double> wavelength{360.0, 830.0}, values{1.0, 1.0};
    int reflectance = 1;
    const char *illuminant = "D65", *observer = "cie1931", *space = "lin_rec709_scene";
    nacre_colour colour{{-7.0}, {-7.0}, {-7.0}};

    nacre_status operator()()
    {
        return nacre_spectrum_to_colour(values.size(), wavelength.data(), values.data(),
                                        reflectance, illuminant, observer, space, &colour);
    }
};

TEST(CapiColour, PerfectWhiteIsOne)
{
    for (const char* illuminant : {"D65", "A", "E", "D50"}) {
        for (const char* space : {"lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"}) {
            Spectrum white;
            white.illuminant = illuminant;
            white.space = space;
            ASSERT_EQ(white(), NACRE_OK);
            for (const double channel : white.colour.rgb) EXPECT_NEAR(channel, 1.0, 1e-12);
            EXPECT_NEAR(white.colour.XYZ[1], 1.0, 1e-14);
            EXPECT_NEAR(white.colour.Lab[0], 100.0, 1e-11);
            EXPECT_NEAR(white.colour.Lab[1], 0.0, 1e-10);
        }
    }
}

TEST(CapiColour, EmissionNeedsNoIlluminant)
{
    Spectrum equal_energy;
    equal_energy.reflectance = 0;
    equal_energy.illuminant = nullptr;
    ASSERT_EQ(equal_energy(), NACRE_OK);
    for (const double value : equal_energy.colour.XYZ) EXPECT_NEAR(value, 1.0, 1e-3);
}

TEST(CapiColour, RefusesUnknownNamesAndBadSamples)
{
    const auto with = [](auto&& change) {
        Spectrum spectrum;
        change(spectrum);
        const std::string message = error(spectrum());
        EXPECT_EQ(spectrum.colour.XYZ[0], -7.0) << message;
        return message;
    };
    EXPECT_NE(with([](Spectrum& s) { s.illuminant = "X"; }).find("D65"), std::string::npos);
    EXPECT_NE(with([](Spectrum& s) { s.observer = "X"; }).find("cie1964"), std::string::npos);
    EXPECT_NE(with([](Spectrum& s) { s.space = "X"; }).find("lin_ap1_scene"), std::string::npos);
    const std::string descending = with([](Spectrum& s) { s.wavelength = {500.0, 400.0}; });
    EXPECT_TRUE(descending.starts_with("wavelength_nm")) << descending;
    EXPECT_NE(with([](Spectrum& s) { s.values[1] = kNan; }), "");
    EXPECT_NE(with([](Spectrum& s) { s.values.clear(); }), "");
    EXPECT_NE(with([](Spectrum& s) { s.wavelength = {100.0, 200.0}; }), "");  // off the grid
    EXPECT_EQ(with([](Spectrum& s) { s.illuminant = nullptr; }), "illuminant: must not be null");
    EXPECT_EQ(with([](Spectrum& s) { s.observer = nullptr; }), "observer: must not be null");
    EXPECT_EQ(with([](Spectrum& s) { s.space = nullptr; }), "space: must not be null");
}

TEST(CapiColour, RefusesNullArrays)
{
    const double value = 1.0;
    nacre_colour colour;
    const auto call = [](const double* nm, const double* values, nacre_colour* out) {
        return error(nacre_spectrum_to_colour(1, nm, values, 0, nullptr, "cie1931",
                                              "lin_rec709_scene", out));
    };
    EXPECT_EQ(call(&value, &value, nullptr), "colour: must not be null");
    EXPECT_EQ(call(nullptr, &value, &colour), "wavelength_nm: must not be null");
    EXPECT_EQ(call(&value, nullptr, &colour), "values: must not be null");
}

TEST(CapiColour, HasASpectrumForEachPrimary)
{
    std::vector<double> values(3 * NACRE_WAVELENGTHS);
    ASSERT_EQ(nacre_rgb_basis(values.data()), NACRE_OK);
    for (std::size_t i = 0; i < values.size(); i += 3)
        EXPECT_NEAR(values[i] + values[i + 1] + values[i + 2], 1.0, 1e-9);
    EXPECT_EQ(error(nacre_rgb_basis(nullptr)), "values: must not be null");
}

}  // namespace
