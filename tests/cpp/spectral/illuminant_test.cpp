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

TEST(NamedIlluminant, HoldsTheTablesOfTheCie)
{
    // ISO/CIE 11664-2:2022, table 1; CIE 015:2018, table 6.
    EXPECT_EQ(named_illuminant("D65").power[at_nm(560)], 100.0);
    EXPECT_EQ(named_illuminant("D65").power[at_nm(400)], 82.7549);
    EXPECT_EQ(named_illuminant("A").power[at_nm(450)], 33.0859);
    EXPECT_EQ(named_illuminant("D50").power[at_nm(500)], 95.724);
    for (const double power : named_illuminant("E").power) EXPECT_EQ(power, 1.0);
}

TEST(NamedIlluminant, IsLinearBetweenSamplesAndHeldAboveThem)
{
    const Sampled& power = named_illuminant("D65").power;
    EXPECT_NEAR(power[at_nm(402)], 82.7549 + 0.4 * (87.1204 - 82.7549), 1e-12);
    EXPECT_EQ(power[at_nm(780)], 63.3828);
    EXPECT_EQ(power[at_nm(830)], 63.3828);
}

TEST(LightSpectrum, GoesOnBeyondTheGrid)
{
    const auto at = [](const char* name, double nm) {
        const double wavelengths[] = {nm};
        return light_spectrum(name).values_at(wavelengths)[0];
    };
    // CIE 015:2018: D65 and the components of daylight; Planck's law, not the value at 360 nm.
    EXPECT_EQ(at("D65", 325.0), 28.6447);
    const double d65 = at("daylight:6504", 325.0) / at("daylight:6504", 560.0);
    EXPECT_NEAR(d65, 0.286447, 4e-4);
    const double planck = std::pow(560.0 / 325.0, 5.0) * std::expm1(1.4388e7 / (560.0 * 3000.0)) /
                          std::expm1(1.4388e7 / (325.0 * 3000.0));
    EXPECT_NEAR(at("blackbody:3000", 325.0), 100.0 * planck, 1e-11);
    EXPECT_EQ(at("line:360", 360.0), 1.0);
    EXPECT_EQ(at("line:360", 359.0), 0.0);
    EXPECT_EQ(at("line:830", 835.0), 0.0);
    for (const char* name :
         {"D65", "F3", "lamp/hps", "blackbody:3000", "daylight:5600", "line:550"})
        EXPECT_EQ(light_spectrum(name).on_grid(), named_illuminant(name).power) << name;
}

// CIE 015:2018, table 3 gives these chromaticities to four decimals.
TEST(NamedIlluminant, HasThePublishedChromaticities)
{
    struct Case {
        const char* name;
        double x, y;
    };
    for (const auto& [name, x, y] :
         {Case{"A", 0.4476, 0.4074}, Case{"D50", 0.3457, 0.3585}, Case{"D55", 0.3324, 0.3474},
          Case{"D65", 0.3127, 0.3290}, Case{"D75", 0.2990, 0.3149}, Case{"E", 0.3333, 0.3333}}) {
        const auto xy =
            xyz_to_xy(emission_to_xyz(named_illuminant(name).power, ObserverId::cie1931));
        EXPECT_NEAR(xy[0], x, 1e-4) << name;
        EXPECT_NEAR(xy[1], y, 1e-4) << name;
    }
}

TEST(NamedIlluminant, ReadsItsOwnColumnOfAFamily)
{
    // CIE 015:2018, as colour-science 0.4.6 carries it.
    EXPECT_EQ(named_illuminant("F1").power[at_nm(435)], 43.67);
    EXPECT_EQ(named_illuminant("F12").power[at_nm(545)], 65.4);
    EXPECT_EQ(named_illuminant("LED-B1").power[at_nm(450)], 7.89);
    EXPECT_EQ(named_illuminant("LED-V2").power[at_nm(610)], 16.03);
}

TEST(NamedIlluminant, RefusesOtherNamesWithAList)
{
    EXPECT_EQ(illuminant_names().size(), 29u);
    for (const auto& name : illuminant_names()) EXPECT_EQ(named_illuminant(name).name, name);
    EXPECT_INPUT_ERROR((void)named_illuminant("D60"),
                       "illuminant: must be one of E, A, D65, D50, D55, D75, B, C, F1, ");
    EXPECT_INPUT_ERROR((void)named_illuminant("D60"),
                       "LED-V2, a light of the library (lamp/hps), blackbody:<K>, daylight:<K>, "
                       "line:<nm>[@<power>][,<nm>[@<power>]…] (got 'D60')");
    EXPECT_INPUT_ERROR((void)named_illuminant(""), "must be one of");
    EXPECT_INPUT_ERROR((void)named_illuminant("blackbody"), "must be one of");
}

TEST(NamedIlluminant, TakesATemperature)
{
    EXPECT_EQ(named_illuminant("blackbody:3200").power, blackbody(3200).power);
    EXPECT_EQ(named_illuminant("daylight:5600.5").power, daylight(5600.5).power);
    EXPECT_EQ(named_illuminant("blackbody:3200").name, "blackbody:3200");
    EXPECT_INPUT_ERROR((void)named_illuminant("blackbody:hot"),
                       "illuminant: must have a number as temperature in K (got 'hot')");
    EXPECT_INPUT_ERROR((void)named_illuminant("blackbody:3200 K"), "(got '3200 K')");
    EXPECT_INPUT_ERROR((void)named_illuminant("daylight:nan"), "must be within 4000 … 25000 K");
}

TEST(LineSpectrum, ReadsTheObserverAtTheLine)
{
    // 589.3 nm: 0.7 of the value at 589 and 0.3 of that at 590.
    const Observer& cmf = observer(ObserverId::cie1931);
    const Vec3 xyz = emission_to_xyz(named_illuminant("line:589.3").power, ObserverId::cie1931);
    const std::size_t i = at_nm(589);
    EXPECT_NEAR(xyz[0] * cmf.sum_y, 0.7 * cmf.x[i] + 0.3 * cmf.x[i + 1], 1e-12);
    EXPECT_NEAR(xyz[1] * cmf.sum_y, 0.7 * cmf.y[i] + 0.3 * cmf.y[i + 1], 1e-12);
    EXPECT_NEAR(xyz[2] * cmf.sum_y, 0.7 * cmf.z[i] + 0.3 * cmf.z[i + 1], 1e-12);
}

TEST(LineSpectrum, AddsItsLines)
{
    const Sampled& power = named_illuminant("line:360@2,546@0.8,546.5,830").power;
    EXPECT_EQ(power.front(), 2.0);
    EXPECT_NEAR(power[at_nm(546)], 1.3, 1e-15);
    EXPECT_NEAR(power[at_nm(547)], 0.5, 1e-15);
    EXPECT_EQ(power.back(), 1.0);
}

TEST(LineSpectrum, LightsOnlyWhatCanBeAdapted)
{
    const ColourSpace& space = colour_space("lin_rec709_scene");
    EXPECT_INPUT_ERROR(
        (void)reflectance_weights(named_illuminant("line:589.3"), ObserverId::cie1931, space),
        "illuminant: must have a white that can be adapted");
    Sampled white;
    white.fill(1.0);
    const Vec3 rgb = reflectance_weights(named_illuminant("line:435.8@1,546.1@0.8,611@0.7"),
                                         ObserverId::cie1931, space)
                         .apply(white);
    for (const double value : rgb) EXPECT_NEAR(value, 1.0, 1e-12);
}

TEST(LineSpectrum, RefusesWhatIsNoLine)
{
    EXPECT_INPUT_ERROR((void)line_spectrum({}), "illuminant: must have at least one line");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:"), "a number as wavelength (got '')");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:546,"), "a number as wavelength (got '')");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:546@"), "a number as power (got '')");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:546@1@2"), "as power (got '1@2')");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:359.9"), "within 360 … 830 nm (got 359.9)");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:nan"), "(got nan)");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:546@0"), "a finite power > 0 (got 0)");
    EXPECT_INPUT_ERROR((void)named_illuminant("line:546@inf"), "a finite power > 0 (got inf)");
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
