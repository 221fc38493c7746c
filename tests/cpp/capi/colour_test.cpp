// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/colour.h"
#include "refusal.h"

#include <gtest/gtest.h>

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

}  // namespace
