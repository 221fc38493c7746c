// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/lights.h"

#include <cmath>

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

}  // namespace
}  // namespace nacre::spectral
