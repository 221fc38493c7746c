// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/spectrum_library.h"

#include <algorithm>
#include <map>
#include <string>

#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/spectral/colour.h"
#include "spectral/grid.h"
#include "support/expect.h"
#include "support/own_library.h"

namespace nacre::spectral {
namespace {

TEST(SpectrumLibrary, EveryEntryHasACitationALicenceAndSoundValues)
{
    const test::OwnLibrary nothing;
    const auto keys = library_spectrum_keys();
    EXPECT_GE(keys.size(), 165u);
    EXPECT_TRUE(std::ranges::is_sorted(keys));
    std::map<std::string, int> families;
    for (const auto& key : keys) {
        const NamedSpectrum& spectrum = library_spectrum(key);
        EXPECT_EQ(spectrum.key, key);
        EXPECT_NE(spectrum.name, "") << key;
        EXPECT_NE(spectrum.name, key);
        EXPECT_NE(spectrum.references, "") << key;
        EXPECT_NE(spectrum.licence, "") << key;
        EXPECT_FALSE(spectrum.tags.empty()) << key;
        ASSERT_TRUE(spectrum.kind) << key;
        EXPECT_FALSE(kind_problem(spectrum.samples, *spectrum.kind)) << key;
        EXPECT_LE(spectrum.samples.first_nm(), 405.0) << key;
        EXPECT_GE(spectrum.samples.last_nm(), 690.0) << key;
        ++families[key.substr(0, key.find('/'))];
    }
    EXPECT_EQ(families["colorchecker"], 24);
    EXPECT_EQ(families["study"], 8);
    EXPECT_EQ(families["cie13.3"], 14);
    EXPECT_EQ(families["cqs"], 15);
    EXPECT_EQ(families["iso7589"], 6);
    EXPECT_GE(families["cie"], 51);
    EXPECT_GE(families["lamp"], 40);
}

TEST(SpectrumLibrary, HasThePublishedColoursOfTheChart)
{
    // ISO 17321-1:2012, table C.1, as X-Rite's: white 9.5 reflects 0.90, black 2 0.03.
    const auto luminance = [](const char* patch) {
        const auto& spectrum = library_spectrum(std::string("colorchecker/") + patch);
        return reflectance_to_xyz(spectrum.on_grid(), named_illuminant("D50"),
                                  ObserverId::cie1931)[1];
    };
    EXPECT_NEAR(luminance("white-9-5"), 0.90, 0.02);
    EXPECT_NEAR(luminance("neutral-5"), 0.198, 0.01);
    EXPECT_NEAR(luminance("black-2"), 0.031, 0.003);
    EXPECT_NEAR(luminance("yellow"), 0.60, 0.02);
}

TEST(SpectrumLibrary, HasTheCieIlluminantsAsTheyAreNamed)
{
    for (const auto& name : illuminant_names()) {
        const NamedSpectrum& spectrum = library_spectrum("cie/" + name);
        EXPECT_EQ(spectrum.on_grid(), named_illuminant(name).power) << name;
        EXPECT_EQ(spectrum.name, "CIE illuminant " + name);
    }
    EXPECT_EQ(library_spectrum("cie/D65").references, "ISO/CIE 11664-2:2022");
}

TEST(SpectrumLibrary, GoldFollowsFromItsOpticalConstants)
{
    const NamedSpectrum& gold = library_spectrum("study/gold");
    const auto& nm = gold.samples.wavelengths_nm();
    for (std::size_t i = 0; i < nm.size(); ++i) {
        const Complex n = library_medium("Au/Johnson").constants->at(nm[i]);
        EXPECT_NEAR(gold.samples.values()[i], std::norm((n - 1.0) / (n + 1.0)), 1e-9) << nm[i];
    }
}

TEST(SpectrumLibrary, LendsItsLightsToWhoeverNamesAnIlluminant)
{
    const Illuminant lamp = named_illuminant("lamp/hps");
    EXPECT_EQ(lamp.name, "lamp/hps");
    EXPECT_EQ(lamp.power, library_spectrum("lamp/hps").on_grid());
    // CIE 015:2018, table 11, standard high-pressure sodium lamp, to three decimals.
    const auto xy =
        xyz_to_xy(emission_to_xyz(named_illuminant("cie/HP1").power, ObserverId::cie1931));
    EXPECT_NEAR(xy[0], 0.533, 5e-4);
    EXPECT_NEAR(xy[1], 0.415, 5e-4);
    EXPECT_INPUT_ERROR((void)named_illuminant("study/gold"),
                       "illuminant: must be a light; study/gold is a reflectance");
    EXPECT_INPUT_ERROR((void)named_illuminant("lamp/hsp"), "lamp/hps");
    EXPECT_EQ(named_illuminant("study/box").power[at_nm(449)], 0.0);
    EXPECT_EQ(named_illuminant("study/box").power[at_nm(450)], 1.0);
}

TEST(SpectrumLibrary, NamesNearKeys)
{
    EXPECT_INPUT_ERROR((void)library_spectrum("colorchecker/dark-skn"),
                       "spectrum: must be a key of the library, perhaps colorchecker/dark-skin "
                       "(got 'colorchecker/dark-skn')");
    EXPECT_INPUT_ERROR((void)library_spectrum("../../../etc/passwd"), "must be a key");
    EXPECT_INPUT_ERROR((void)library_spectrum(""), "must be a key");
    EXPECT_INPUT_ERROR((void)library_spectrum(std::string(1 << 20, 'x')), "must be a key");
}

}  // namespace
}  // namespace nacre::spectral
