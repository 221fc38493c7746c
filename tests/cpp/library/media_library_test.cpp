// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/media/optical_constants.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

TEST(Library, EveryEntryParsesAndHasACitation)
{
    const auto keys = library_keys();
    EXPECT_GE(keys.size(), 199u);
    EXPECT_TRUE(std::ranges::is_sorted(keys));
    for (const auto& key : keys) {
        const Medium& medium = library_medium(key);
        EXPECT_EQ(medium.key, key);
        EXPECT_NE(medium.name, "") << key;
        EXPECT_NE(medium.references, "") << key;
        EXPECT_FALSE(medium.tags.empty()) << key;
        const auto [first, last] = medium.constants->range_nm();
        // The published curves of these five start in the blue.
        const bool starts_late = key == "PC/Sultanova" || key == "PMMA/Sultanova" ||
                                 key == "PS/Sultanova" || key.starts_with("TiO2/Devore-");
        EXPECT_LE(first, starts_late ? 436.8 + 1e-9 : 400.0 + 1e-9) << key;
        EXPECT_GE(last, 700.0 - 1e-9) << key;
        const double end = std::min(last, 1e5);
        for (int i = 0; i <= 50; ++i) {
            const double nm = std::clamp(std::lerp(first, end, i / 50.0), first, end);
            if (nm <= 0.0) continue;
            EXPECT_GT(medium.constants->at(nm).real(), 0.0) << key << ' ' << nm;
        }
    }
}

TEST(Library, KnowsFormulaAndKind)
{
    using Tags = std::vector<std::string>;
    EXPECT_EQ(library_medium("Au/Johnson").formula, "Au");
    EXPECT_EQ(library_medium("Au/Johnson").tags, Tags{"metal"});
    EXPECT_EQ(library_medium("ethanol/Chang").formula, "C2H6O");
    EXPECT_EQ(library_medium("brass/Querry-Cu70Zn30").tags, (Tags{"metal", "alloy"}));
    EXPECT_EQ(library_medium("N-BK7/SCHOTT").formula, "");
    std::map<std::string, int> count;
    for (const auto& key : library_keys())
        for (const auto& tag : library_medium(key).tags) ++count[tag];
    for (const char* tag :
         {"metal", "oxide", "nitride", "semiconductor", "glass", "polymer", "liquid", "biological"})
        EXPECT_GE(count[tag], 6) << tag;
}

// Handbook values at the d line: CRC, 20 °C (ethanol, glycerol at 25 °C), OHARA catalogue.
TEST(Library, HasTheIndicesOfHandbooks)
{
    EXPECT_NEAR(library_medium("ethanol/Chang").constants->at(587.5618).real(), 1.3614, 2e-3);
    EXPECT_NEAR(library_medium("glycerol/Gupta").constants->at(587.5618).real(), 1.4730, 3e-3);
    EXPECT_NEAR(library_medium("toluene/Chang").constants->at(587.5618).real(), 1.4961, 3e-3);
    EXPECT_NEAR(library_medium("LiF/Li").constants->at(587.5618).real(), 1.3921, 1e-3);
    EXPECT_NEAR(library_medium("S-FPL53/OHARA").constants->at(587.5618).real(), 1.43875, 1e-5);
    EXPECT_NEAR(library_medium("air/Ciddor").constants->at(587.5618).real(), 1.000277, 1e-6);
}

// Leertouwer et al. 2011, abstract: 400, 500 and 600 nm. Stavenga et al. 2015: 1.7 to 1.8.
TEST(Library, HasTheMatterOfWingsAndFeathers)
{
    for (const auto& [key, indices] :
         {std::pair{"chitin/Leertouwer", std::array{1.572, 1.552, 1.541}},
          std::pair{"keratin/Leertouwer", std::array{1.569, 1.556, 1.548}}})
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(library_medium(key).constants->at(400.0 + 100.0 * double(i)).real(),
                        indices[i], 6e-4)
                << key;
    const auto& melanin = *library_medium("melanin/Stavenga").constants;
    EXPECT_NEAR(melanin.at(420.0).real(), 1.8, 0.02);
    EXPECT_NEAR(melanin.at(700.0).real(), 1.7, 0.01);
    EXPECT_NEAR(melanin.at(545.0).imag(), 0.56 * std::exp(-545.0 / 270.0), 5e-5);
}

// What the supplied templates and the documentation name.
TEST(Library, HoldsTheMediaOfTheTemplates)
{
    for (const char* key :
         {"water/Daimon-20C", "Fe3O4/Querry", "Fe/Johnson", "Ti/Johnson", "TiO2/Sarkar",
          "SiO2/Malitson", "MgF2/Dodge-o", "Cr/Johnson", "Al/Rakic", "Au/Johnson", "Ag/Johnson",
          "Cu/Johnson", "Ni/Johnson", "Si/Green-2008", "N-BK7/SCHOTT", "Nb2O5/Lemarchand"}) {
        const auto [first, last] = library_medium(key).constants->range_nm();
        EXPECT_LE(first, 360.0) << key;
        EXPECT_GE(last, 830.0) << key;
        EXPECT_EQ(library_medium(key).constants->on_grid().size(), kWavelengths);
    }
}

// Daimon and Masumura 2007, table 5: 20.0 °C, d line. SCHOTT and Peter: n_d. Johnson and Christy
// 1972 and 1974, Rakic 1995 and Querry 1985: rows of their tables.
TEST(Library, HasThePublishedIndices)
{
    EXPECT_NEAR(library_medium("water/Daimon-20C").constants->at(587.5618).real(), 1.33340, 5e-6);
    EXPECT_NEAR(library_medium("N-BK7/SCHOTT").constants->at(587.5618).real(), 1.51680, 5e-6);
    EXPECT_NEAR(library_medium("N-SF11/SCHOTT").constants->at(587.5618).real(), 1.78472, 5e-6);
    EXPECT_NEAR(library_medium("SiO2/Malitson").constants->at(587.5618).real(), 1.45846, 5e-6);
    EXPECT_NEAR(library_medium("diamond/Peter").constants->at(587.5618).real(), 2.4175, 5e-5);
    EXPECT_COMPLEX_NEAR(library_medium("Ag/Johnson").constants->at(582.1), Complex(0.05, 3.858),
                        1e-12);
    EXPECT_COMPLEX_NEAR(library_medium("Fe/Johnson").constants->at(451.0), Complex(2.59, 2.77),
                        1e-12);
    EXPECT_COMPLEX_NEAR(library_medium("Fe3O4/Querry").constants->at(500.0), Complex(2.359, 0.071),
                        1e-12);
}

TEST(Library, AirAndVacuumAreOne)
{
    for (const char* key : {"air", "vacuum"})
        EXPECT_EQ(library_medium(key).constants->at(500.0), Complex(1.0, 0.0));
}

TEST(Library, SuggestsWhatMayHaveBeenMeant)
{
    EXPECT_INPUT_ERROR((void)library_medium("Water/daimon-20"),
                       "medium: must be a key of the library, perhaps water/Daimon-20C");
    EXPECT_INPUT_ERROR((void)library_medium("BK7/SCHOTT"), "perhaps N-BK7/SCHOTT");
    EXPECT_INPUT_ERROR((void)library_spectrum("d65"), "perhaps cie/D65 (got 'd65')");
    EXPECT_INPUT_ERROR((void)library_medium("TiO2"), "TiO2/Sarkar");
    EXPECT_INPUT_ERROR((void)library_medium("unobtainium/Cameron"),
                       "must be a key of the library (got 'unobtainium/Cameron')");
    EXPECT_INPUT_ERROR((void)library_medium(""), "must be a key of the library");
    EXPECT_INPUT_ERROR((void)library_medium("../cmf/cie_1931_2deg_1nm"), "must be a key");
}

TEST(Library, OutOfRangeNamesMediumAndRange)
{
    EXPECT_INPUT_ERROR(
        (void)library_medium("diamond/Peter").constants->on_grid(),
        "diamond/Peter: wavelength_nm: must be within the data, 226 … 760 nm (got 761)");
    EXPECT_INPUT_ERROR((void)library_medium("SF11/SCHOTT").constants->at(360.0),
                       "390 … 2500 nm (got 360)");
}

TEST(Library, IsTheSameFromManyThreads)
{
    std::vector<const Medium*> seen(8);
    {
        std::vector<std::jthread> threads;
        threads.reserve(seen.size());
        for (auto& medium : seen)
            threads.emplace_back([&medium] { medium = &library_medium("Cu/Johnson"); });
    }
    for (const Medium* medium : seen) EXPECT_EQ(medium, seen.front());
}

}  // namespace
}  // namespace nacre::spectral
