// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/illuminant.h"

#include <cmath>
#include <limits>

#include "nacre/spectral/colour.h"
#include "spectral/grid.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

TEST(CieIlluminant, HasThePublishedSamples)
{
    // ISO/CIE 11664-2:2022, table 1.
    const auto d65 = illuminant_samples("D65");
    ASSERT_TRUE(d65);
    EXPECT_EQ(d65->first_nm(), 300.0);
    EXPECT_EQ(d65->at(560.0), 100.0);
    EXPECT_EQ(cie_illuminant("D65").power, d65->on_grid(Interpolation::linear));
    EXPECT_FALSE(illuminant_samples("lamp/hps"));
    EXPECT_FALSE(illuminant_samples("blackbody:3200"));
    EXPECT_INPUT_ERROR((void)cie_illuminant("D60"), "illuminant: must be one of E, A, D65, ");
}

TEST(CieIlluminant, NamesItsSource)
{
    EXPECT_EQ(illuminant_citation("E").references, "CIE 015:2018");
    for (const std::string& name : illuminant_names()) {
        EXPECT_FALSE(illuminant_citation(name).references.empty()) << name;
        EXPECT_FALSE(illuminant_citation(name).licence.empty()) << name;
    }
}

TEST(LineSpectrum, IsZeroBesideTheGrid)
{
    const Spectrum samples = line_samples({{360.0, 2.0}});
    EXPECT_EQ(samples.first_nm(), 359.0);
    EXPECT_EQ(samples.at(359.0), 0.0);
    EXPECT_EQ(samples.at(360.0), 2.0);
    EXPECT_EQ(line_spectrum({{360.0, 2.0}}).power[0], 2.0);
    EXPECT_INPUT_ERROR((void)line_samples({}), "illuminant: must have at least one line");
}

// colour-science 0.4.6, sd_blackbody on the grid of the observer, and XYZ_to_xy of its XYZ.
TEST(Blackbody, MatchesColourScience)
{
    struct Case {
        double kelvin, x, y, at_450;
    };
    for (const auto& [kelvin, x, y, at_450] :
         {Case{1500, 0.5857209924342879, 0.39311968684424115, 4.534124577402402},
          Case{2856, 0.44753864026831874, 0.40742930074995487, 33.097566053905794},
          Case{6504, 0.31346516036524324, 0.3235691545772494, 112.26956238239403},
          Case{20000, 0.2564575760515238, 0.2576313240325463, 197.64005212912764}}) {
        const Illuminant body = blackbody(kelvin);
        const auto xy = xyz_to_xy(emission_to_xyz(body.power, ObserverId::cie1931));
        EXPECT_NEAR(xy[0], x, 1e-12) << kelvin;
        EXPECT_NEAR(xy[1], y, 1e-12) << kelvin;
        EXPECT_NEAR(body.power[at_nm(450)], at_450, 1e-11) << kelvin;
        EXPECT_EQ(body.power[at_nm(560)], 100.0);
    }
}

TEST(Blackbody, IsFiniteOverItsWholeRange)
{
    for (const double kelvin : {100.0, 1e6})
        for (const double power : blackbody(kelvin).power) {
            EXPECT_TRUE(std::isfinite(power)) << kelvin;
            EXPECT_GE(power, 0.0) << kelvin;
        }
    // Rayleigh-Jeans limit: power goes as λ⁻⁴ where c2 / λT is small.
    const Sampled& hot = blackbody(1e6).power;
    EXPECT_NEAR(hot[at_nm(830)] / hot[at_nm(415)], 0.0625, 0.0015);
}

TEST(Blackbody, RefusesWhatIsOutOfRange)
{
    EXPECT_INPUT_ERROR((void)blackbody(99.0),
                       "blackbody_K: must be within 100 … 1000000 K (got 99)");
    EXPECT_INPUT_ERROR((void)blackbody(-1.0), "(got -1)");
    EXPECT_INPUT_ERROR((void)blackbody(std::numeric_limits<double>::quiet_NaN()), "(got nan)");
    EXPECT_INPUT_ERROR((void)blackbody(std::numeric_limits<double>::infinity()), "(got inf)");
}

// colour-science 0.4.6: sd_CIE_illuminant_D_series(CCT_to_xy_CIE_D(T)), aligned to 1 nm.
TEST(Daylight, MatchesColourScience)
{
    struct Case {
        double kelvin, at_360, at_502, at_830, x, y;
    };
    for (const auto& [kelvin, at_360, at_502, at_830, x, y] :
         {Case{4000, 19.2931, 85.03458, 95.0245, 0.3823832081291269, 0.3836863388056039},
          Case{5003, 23.9366, 95.90308, 74.4352, 0.34567758475311167, 0.3585020869166658},
          Case{6504, 46.6763, 109.05954, 60.3027, 0.3126951098813602, 0.32898988458100814},
          Case{7500, 62.944, 115.996, 55.5488, 0.2990660941707987, 0.31490079450105024},
          Case{25000, 180.7375, 155.5729, 44.1689, 0.24981277294371085, 0.2547208084203188}}) {
        const Illuminant light = daylight(kelvin);
        EXPECT_NEAR(light.power[at_nm(360)], at_360, 1e-11) << kelvin;
        EXPECT_NEAR(light.power[at_nm(502)], at_502, 1e-5) << kelvin;  // as printed there
        EXPECT_NEAR(light.power[at_nm(830)], at_830, 1e-11) << kelvin;
        const auto xy = xyz_to_xy(emission_to_xyz(light.power, ObserverId::cie1931));
        EXPECT_NEAR(xy[0], x, 1e-12) << kelvin;
        EXPECT_NEAR(xy[1], y, 1e-12) << kelvin;
    }
}

TEST(Daylight, RefusesWhatIsOutOfRange)
{
    EXPECT_INPUT_ERROR((void)daylight(3999.0),
                       "daylight_K: must be within 4000 … 25000 K (got 3999)");
    EXPECT_INPUT_ERROR((void)daylight(25001.0), "(got 25001)");
    EXPECT_INPUT_ERROR((void)daylight(std::numeric_limits<double>::quiet_NaN()), "(got nan)");
}

}  // namespace
}  // namespace nacre::spectral
