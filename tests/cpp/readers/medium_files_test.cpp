// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <vector>

#include "nacre/media/optical_constants.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

std::string yaml_of_csv(const std::string& text)
{
    std::vector<std::string> changes;
    return refractiveindex_yaml_from_csv(text, "x.csv", "", changes);
}

TEST(CsvMedium, SaysWhatWasPutRight)
{
    std::vector<std::string> changes;
    const Medium medium = parse_refractiveindex_yaml(
        refractiveindex_yaml_from_csv("nm,n,k\n400,1.5,-1e-17\n500,1.4,0.5\n", "x.csv", "",
                                      changes),
        "x");
    EXPECT_EQ(changes, std::vector<std::string>{
                           "k < 0 taken as 0 (1 row, the first in line 2, k down to -1e-17)"});
    EXPECT_EQ(medium.comments, "Changed when it was imported: " + changes.front());
    EXPECT_TRUE(medium.changes.empty());
    EXPECT_EQ(medium.constants->at(400), Complex(1.5, 0.0));
}

TEST(CsvMedium, BecomesOpticalConstants)
{
    std::vector<std::string> changes;
    const std::string yaml = refractiveindex_yaml_from_csv(
        "# NAME: My \"oil\"\nwavelength_nm,n,k\n400,1.5,0\n700,1.4,0.25\n", "oil.csv", "me \\ 2020",
        changes);
    const Medium medium = parse_refractiveindex_yaml(yaml, "oil");
    EXPECT_EQ(medium.name, "My \"oil\"");
    EXPECT_EQ(medium.references, "me \\ 2020");
    EXPECT_COMPLEX_NEAR(medium.constants->at(700), Complex(1.4, 0.25), 1e-15);
    EXPECT_COMPLEX_NEAR(medium.constants->at(550), Complex(1.45, 0.125), 1e-12);
}

TEST(CsvMedium, ReadsWhatRefractiveindexInfoExports)
{
    const auto index = [](const char* text) {
        return parse_refractiveindex_yaml(yaml_of_csv(text), "x").constants->at(500);
    };
    EXPECT_COMPLEX_NEAR(index("wl,n\n0.4,1.5\n0.5,1.4\n"), Complex(1.4, 0), 1e-15);
    EXPECT_COMPLEX_NEAR(index("wl,n\n0.4,1.5\n0.5,1.4\n\nwl,k\n0.4,1\n0.5,2\n"), Complex(1.4, 2),
                        1e-15);
    EXPECT_INPUT_ERROR((void)index("wl,n\n0.4,1.5\n0.5,1.4\nwl,k\n0.4,1\n0.6,2\n"),
                       "x.csv:4: must have the wavelengths of the table before");
}

TEST(CsvMedium, NamesEveryProblemWithItsLine)
{
    EXPECT_EQ(
        test::input_error_of([] { (void)yaml_of_csv("nm,n,k\n400,0,1\n500,1,-1\n"); }),
        "x.csv:2: n: must be > 0 (got 0)\nx.csv:3: k: must be ≥ 0, or ≥ -0.005 for the noise of a "
        "measurement (got -1)");
    EXPECT_INPUT_ERROR((void)yaml_of_csv("400,1\n500,1\n"),
                       "must have a row of names with a column n");
}

TEST(MediumFromSpd, StandsAtTheWavelengthsOfBothFiles)
{
    std::vector<std::string> changes;
    const std::string yaml = refractiveindex_yaml_from_spd(
        "# n\n300 1.5\n400 0.5\n700 1.1\n", "Au.eta.spd",
        "350 2\n400 3\n600 4\n700 -1e-17\n800 6\n", "Au.k.spd", "A \"book\"", changes);
    const Medium gold = parse_refractiveindex_yaml(yaml, "gold");
    EXPECT_EQ(gold.references, "A \"book\"");
    EXPECT_EQ(gold.constants->range_nm(), (std::array<double, 2>{350, 700}));
    EXPECT_COMPLEX_NEAR(gold.constants->at(350), Complex(1.0, 2.0), 1e-12);
    EXPECT_COMPLEX_NEAR(gold.constants->at(400), Complex(0.5, 3.0), 1e-12);
    EXPECT_COMPLEX_NEAR(gold.constants->at(600), Complex(0.9, 4.0), 1e-12);
    EXPECT_COMPLEX_NEAR(gold.constants->at(700), Complex(1.1, 0.0), 1e-12);
    EXPECT_EQ(changes, std::vector<std::string>{"Au.k.spd: k < 0 taken as 0 (1 row)"});
    EXPECT_NE(gold.comments.find(changes.front()), std::string::npos);
}

TEST(MediumFromSpd, NamesWhatIsWrongWithEitherFile)
{
    const auto read = [](const char* n, const char* k) {
        return test::input_error_of([&] {
            std::vector<std::string> changes;
            (void)refractiveindex_yaml_from_spd(n, "a.eta.spd", k, "a.k.spd", "", changes);
        });
    };
    const std::string both = read("400 x\n500 1\n", "400\n");
    EXPECT_NE(both.find("a.eta.spd:1: value: must be a finite number"), std::string::npos) << both;
    EXPECT_NE(both.find("a.k.spd:1: must be a wavelength and a value"), std::string::npos) << both;
    const std::string signs = read("400 0\n500 1\n", "400 1\n500 -1\n");
    EXPECT_NE(signs.find("a.eta.spd: n: must be > 0 (got 0 at 400 nm)"), std::string::npos)
        << signs;
    EXPECT_NE(signs.find("a.k.spd: k: must be ≥ 0 (got -1 at 500 nm)"), std::string::npos) << signs;
    EXPECT_NE(
        read("400 1\n500 1\n", "600 1\n700 1\n")
            .find("a.k.spd: wavelength: must overlap 400 … 500 nm of a.eta.spd (got 600 … 700)"),
        std::string::npos);
}

}  // namespace
}  // namespace nacre::spectral
