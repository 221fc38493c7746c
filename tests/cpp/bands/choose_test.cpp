// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/choose.h"

#include <cmath>

#include "reflectances.h"
#include "support/expect.h"

namespace nacre::bands {
namespace {

using spectral::ObserverId;

Choice choose(Needs needs)
{
    return choose_bands(needs, ObserverId::cie1931);
}

Needs under(std::initializer_list<const char*> names)
{
    Needs needs{.lights = {},
                .reflectances = shipped_reflectances("colorchecker/"),
                .films = {},
                .spreads = {}};
    for (const char* name : names) needs.lights.push_back(named_light(name));
    return needs;
}

TEST(BandError, OfEveryLampOfTheLibraryIsSmallInEightPasses)
{
    const std::vector<Fine> reflectances = shipped_reflectances();
    ASSERT_GT(reflectances.size(), 50u);
    int lamps = 0;
    for (const std::string& key : spectral::library_spectrum_keys()) {
        if (spectral::library_spectrum(key).kind != spectral::SpectrumKind::emission) continue;
        ++lamps;
        const Light light = named_light(key);
        const Bands made = make_bands(24, {&light, 1}, ObserverId::cie1931);
        const BandError error = band_error(made, light, reflectances);
        EXPECT_LE(error.mean, 0.1) << key;
        EXPECT_LE(error.max, 0.3) << key;
    }
    EXPECT_GT(lamps, 90);
}

TEST(BandError, FallsWithTheNumberOfBands)
{
    const std::vector<Fine> reflectances = shipped_reflectances("colorchecker/");
    const Light light = named_light("F11");
    double before = 1.0;
    for (const int count : {12, 24, 48, 96}) {
        const Bands made = make_bands(count, {&light, 1}, ObserverId::cie1931);
        const double error = band_error(made, light, reflectances).mean;
        EXPECT_LT(error, 0.5 * before) << count;
        before = error;
    }
}

// A light that bands were not made for is still near: an artist may exchange a lamp afterwards.
TEST(BandError, OfAnotherLightIsSmallToo)
{
    const std::vector<Fine> reflectances = shipped_reflectances("colorchecker/");
    const Light daylight = named_light("D65");
    const Bands made = make_bands(48, {&daylight, 1}, ObserverId::cie1931);
    for (const char* name : {"A", "F2", "F11", "LED-B3", "lamp/hps"})
        EXPECT_LT(band_error(made, named_light(name), reflectances).mean, 0.05) << name;
}

TEST(BandError, IsThatOfASurfaceThatBandsCannotTell)
{
    // A comb of half the bands' distance is read at its teeth or between them.
    Fine comb(kFineWavelengths);
    for (std::size_t i = 0; i < comb.size(); ++i) comb[i] = (i / 10) % 2 == 0 ? 1.0 : 0.0;
    const Light light = named_light("D65");
    const Bands made = make_bands(24, {&light, 1}, ObserverId::cie1931);
    EXPECT_GT(band_error(made, light, {&comb, 1}).max, 5.0);
}

TEST(Fringes, AreThoseOfNineFilms)
{
    const std::vector<Fine> films = fringes(1000.0);
    ASSERT_EQ(films.size(), 9u);
    // The one in the middle: 4π nd / λ is a whole number of turns at 500 nm, so it is dark there.
    EXPECT_NEAR(films[4][1400], 0.0, 1e-3);
    EXPECT_NEAR(fine_nm(1400), 500.05, 1e-9);
    for (const Fine& film : films)
        for (const double value : film) EXPECT_TRUE(value >= 0.0 && value <= 1.0);
}

TEST(Choose, EightPassesAreEnoughForOneLamp)
{
    for (const char* name : {"D65", "A", "F2", "F11", "LED-B3", "lamp/hps", "lamp/lps"}) {
        const Choice choice = choose(under({name}));
        EXPECT_EQ(choice.passes, 8) << name;
        EXPECT_TRUE(choice.met);
        EXPECT_EQ(choice.held, "lights");
        EXPECT_LE(choice.error.mean, 0.1);
        EXPECT_EQ(choice.bands.size(), 24u);
    }
}

TEST(Choose, StricterErrorsTakeMorePasses)
{
    Needs needs = under({"D65", "F11", "lamp/hps"});
    const int passes = choose(needs).passes;
    needs.mean_error = 0.01;
    const Choice choice = choose(needs);
    EXPECT_GT(choice.passes, passes);
    EXPECT_TRUE(choice.met);
    EXPECT_LE(choice.error.mean, 0.01);
}

TEST(Choose, FilmsTakeMoreTheThickerTheyAre)
{
    int before = 0;
    for (const double nd : {300.0, 2000.0, 4000.0, 8000.0}) {
        Needs needs = under({"D65"});
        needs.films = {{nd, {}}};
        const Choice choice = choose(needs);
        EXPECT_TRUE(choice.met) << nd;
        EXPECT_GE(choice.passes, before) << nd;
        EXPECT_EQ(choice.held, "films") << nd;
        before = choice.passes;
    }
    EXPECT_GT(before, 20);
}

TEST(Choose, FilmsOfLowContrastTakeFewPasses)
{
    Needs needs = under({"D65"});
    Film faint{4000.0, fringes(4000.0)};
    for (Fine& reflectance : faint.reflectances)
        for (double& value : reflectance) value = 0.5 + 0.004 * (value - 0.5);
    needs.films = {faint};
    EXPECT_EQ(choose(needs).passes, kPasses[0]);
    needs.films = {{4000.0, fringes(4000.0)}};
    const int passes = choose(needs).passes;
    EXPECT_GT(passes, 20);
    needs.films = {{4000.0, {}}};
    EXPECT_EQ(choose(needs).passes, passes);
}

// Nobody sees them: their colour is that of their mean, which a band has.
TEST(Choose, FringesThatAreFinerThanTheEyeTakeFewPasses)
{
    Needs needs = under({"D65"});
    needs.films = {{60'000.0, {}}};
    const Choice choice = choose(needs);
    EXPECT_TRUE(choice.met);
    EXPECT_LE(choice.passes, 20);
    EXPECT_LE(choice.films, 0.1);
}

TEST(Choose, SaysWhenTheMostPassesAreNotEnough)
{
    Needs needs = under({"D65"});
    needs.films = {{8000.0, {}}};
    needs.mean_error = 1e-4;
    needs.reflectances.clear();
    const Choice choice = choose(needs);
    EXPECT_FALSE(choice.met);
    EXPECT_EQ(choice.passes, 100);
    EXPECT_EQ(choice.held, "films");
    EXPECT_GT(choice.films, 1e-4);
}

TEST(Choose, SpreadWavelengthsAreAPixelApart)
{
    Needs needs = under({"D65"});
    Spread spread;
    for (const double nm : fine_grid()) spread.position_px.push_back(65.0 * (nm - 400.0) / 300.0);
    needs.spreads = {spread};
    const Choice choice = choose(needs);
    EXPECT_TRUE(choice.met);
    EXPECT_EQ(choice.held, "spreads");
    EXPECT_LE(choice.step_px, kWidestStepPx);
    EXPECT_GE(choice.bands.size(), 50U);
    EXPECT_LE(choice.bands.size(), 100U);
}

TEST(Choose, LinesTakeABandEach)
{
    std::string many = "line:400";
    for (int nm = 412; nm < 700; nm += 12) many += "," + std::to_string(nm);
    const Choice choice = choose(under({many.c_str()}));
    EXPECT_EQ(choice.passes, 20);  // 25 lines, and 26 bands between them
    EXPECT_EQ(choice.held, "lines");
    EXPECT_TRUE(choice.met);
}

TEST(Choose, RefusesWhatCannotBe)
{
    EXPECT_INPUT_ERROR(choose({}), "lights: must be one or more");
    std::string many = "line:380";
    for (int nm = 382; nm < 780; nm += 2) many += "," + std::to_string(nm);
    EXPECT_INPUT_ERROR(choose(under({many.c_str()})), "for all the lines");
}

}  // namespace
}  // namespace nacre::bands
