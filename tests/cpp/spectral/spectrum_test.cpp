// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum.h"

#include <cmath>
#include <limits>

#include "spectral/grid.h"
#include "support/expect.h"
#include "support/not_numbers.h"

namespace nacre::spectral {
namespace {

using test::kInf;
using test::kNan;

std::vector<double> steps(double first, double last, double step)
{
    std::vector<double> wavelengths;
    for (int i = 0; first + i * step <= last; ++i) wavelengths.push_back(first + i * step);
    return wavelengths;
}

TEST(Spectrum, IsLinearBetweenSamples)
{
    const Spectrum spectrum({400.0, 500.0, 520.0}, {1.0, 2.0, 0.0});
    EXPECT_EQ(spectrum.at(400.0), 1.0);
    EXPECT_EQ(spectrum.at(500.0), 2.0);
    EXPECT_EQ(spectrum.at(520.0), 0.0);
    EXPECT_DOUBLE_EQ(spectrum.at(425.0), 1.25);
    EXPECT_DOUBLE_EQ(spectrum.at(515.0), 0.5);
}

TEST(Spectrum, NamesItsRangeOutsideOfIt)
{
    const Spectrum spectrum({400.0, 500.0}, {1.0, 2.0});
    EXPECT_INPUT_ERROR((void)spectrum.at(399.9),
                       "wavelength_nm: must be within the samples, 400 … 500 nm (got 399.9)");
    EXPECT_INPUT_ERROR((void)spectrum.at(500.1), "400 … 500 nm (got 500.1)");
    EXPECT_INPUT_ERROR((void)spectrum.at(kNan), "(got nan)");
}

TEST(Spectrum, RefusesBadSamplesAllAtOnce)
{
    EXPECT_INPUT_ERROR(Spectrum({500.0}, {1.0}), "must hold at least two samples (got 1)");
    EXPECT_INPUT_ERROR(Spectrum({}, {}), "must hold at least two samples (got 0)");
    EXPECT_INPUT_ERROR(Spectrum({500.0, 510.0}, {1.0}),
                       "values: must be as many as the wavelengths (got 1 for 2)");
    EXPECT_INPUT_ERROR(Spectrum({500.0, 490.0}, {1.0, 1.0}),
                       "wavelength_nm[1]: must be finite, > 0 and ascending (got 490)");
    EXPECT_INPUT_ERROR(Spectrum({500.0, 500.0}, {1.0, 1.0}), "wavelength_nm[1]");
    EXPECT_INPUT_ERROR(Spectrum({-1.0, 500.0}, {1.0, 1.0}), "wavelength_nm[0]");
    EXPECT_INPUT_ERROR(Spectrum({500.0, kNan}, {1.0, 1.0}), "wavelength_nm[1]");
    EXPECT_INPUT_ERROR(Spectrum({500.0, kInf}, {1.0, 1.0}), "wavelength_nm[1]");
    EXPECT_INPUT_ERROR(Spectrum({500.0, 510.0}, {1.0, kNan}),
                       "values[1]: must be finite (got nan)");
    const std::string both = test::input_error_of([] { Spectrum({500.0, 490.0}, {kInf, 1.0}); });
    EXPECT_NE(both.find("wavelength_nm[1]"), std::string::npos) << both;
    EXPECT_NE(both.find("values[0]"), std::string::npos) << both;
}

TEST(Spectrum, KeepsSamplesThatStandOnTheGrid)
{
    std::vector<double> wavelengths = steps(360.0, 830.0, 1.0);
    std::vector<double> values;
    for (const double nm : wavelengths) values.push_back(std::sin(nm));
    const Sampled sampled = Spectrum(wavelengths, values).on_grid();
    for (std::size_t i = 0; i < kWavelengths; ++i) EXPECT_EQ(sampled[i], values[i]) << i;
}

// Sprague's curve reproduces polynomials up to the fourth degree wherever all its six points are
// samples; the two that it makes up beyond each end follow another rule (CIE 167:2005).
TEST(Spectrum, SpragueIsExactForPolynomials)
{
    const auto quartic = [](double nm) {
        const double x = (nm - 595.0) / 235.0;
        return 0.3 + x * (0.5 + x * (-0.2 + x * (0.1 - 0.7 * x)));
    };
    std::vector<double> wavelengths = steps(360.0, 830.0, 10.0);
    std::vector<double> values;
    for (const double nm : wavelengths) values.push_back(quartic(nm));
    const Sampled sampled = Spectrum(wavelengths, values).on_grid();
    for (std::size_t i = at_nm(380); i <= at_nm(810); ++i)
        EXPECT_NEAR(sampled[i], quartic(wavelength_nm(i)), 1e-13) << i;
}

TEST(Spectrum, IsLinearWhereStepsDifferOrSamplesAreFew)
{
    const Sampled uneven =
        Spectrum({360, 400, 450, 500, 600, 700, 830}, {0, 1, 0, 1, 0, 1, 0}).on_grid();
    EXPECT_DOUBLE_EQ(uneven[at_nm(380)], 0.5);
    EXPECT_DOUBLE_EQ(uneven[at_nm(425)], 0.5);
    const Sampled few = Spectrum({400, 500, 600}, {0, 1, 0}).on_grid();
    EXPECT_DOUBLE_EQ(few[at_nm(450)], 0.5);
}

TEST(Spectrum, HoldsTheEndsOutsideTheSamples)
{
    const Sampled sampled = Spectrum({400.0, 700.0}, {0.25, 0.75}).on_grid();
    EXPECT_EQ(sampled[at_nm(360)], 0.25);
    EXPECT_EQ(sampled[at_nm(399)], 0.25);
    EXPECT_EQ(sampled[at_nm(701)], 0.75);
    EXPECT_EQ(sampled[at_nm(830)], 0.75);
}

TEST(Spectrum, MustOverlapTheGrid)
{
    EXPECT_INPUT_ERROR((void)Spectrum({900.0, 1000.0}, {1.0, 1.0}).on_grid(),
                       "wavelength_nm: must overlap 360 … 830 nm (got 900 … 1000)");
    EXPECT_INPUT_ERROR((void)Spectrum({100.0, 200.0}, {1.0, 1.0}).on_grid(), "must overlap");
}

}  // namespace
}  // namespace nacre::spectral
