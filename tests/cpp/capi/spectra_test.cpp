// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/spectra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "refusal.h"
#include "support/own_library.h"

namespace {

using nacre::test::error;

TEST(CapiIlluminant, ByNameAndByForm)
{
    std::vector<double> power(NACRE_WAVELENGTHS);
    ASSERT_EQ(nacre_illuminant("E", power.data()), NACRE_OK);
    EXPECT_EQ(power.front(), power.back());
    ASSERT_EQ(nacre_illuminant("blackbody:2856", power.data()), NACRE_OK);
    EXPECT_DOUBLE_EQ(power[560 - 360], 100.0);
    EXPECT_NE(error(nacre_illuminant("D66", power.data())).find("blackbody:<K>"),
              std::string::npos);
    EXPECT_EQ(error(nacre_illuminant(nullptr, power.data())), "name: must not be null");
}

// CIE 018:2019: 1 at 555 nm and the sum of y, of either observer.
TEST(CapiColourMatching, OfBothObservers)
{
    std::vector<double> xyz(std::size_t{3} * NACRE_WAVELENGTHS);
    const auto sum_y = [&xyz] {
        double sum = 0.0;
        for (std::size_t i = 1; i < xyz.size(); i += 3) sum += xyz[i];
        return sum;
    };
    ASSERT_EQ(nacre_colour_matching("cie1931", xyz.data()), NACRE_OK);
    const double* const green = &xyz[std::size_t{3} * (555 - 360)];
    EXPECT_NEAR(green[0], 0.5120501, 1e-6);
    EXPECT_NEAR(green[1], 1.0, 1e-6);
    EXPECT_NEAR(green[2], 0.00575, 1e-5);
    EXPECT_NEAR(sum_y(), 106.856917, 1e-6);
    ASSERT_EQ(nacre_colour_matching("cie1964", xyz.data()), NACRE_OK);
    EXPECT_NEAR(sum_y(), 116.661877, 1e-6);
    EXPECT_NE(error(nacre_colour_matching("cie2006", xyz.data())).find("cie1931"),
              std::string::npos);
}

// CIE 015: D65 at 6504 K, A at 2856 K on the locus, both by c2 of the temperature scale of today.
TEST(CapiColourTemperature, OfDaylightOfALampAndOfGreen)
{
    const double XYZ[] = {95.047, 100.0, 108.883, 109.85, 100.0, 35.585, 0.2, 1.0, 0.1, 0, 0, 0};
    double cct_K[4], duv[4];
    ASSERT_EQ(nacre_colour_temperature(4, XYZ, cct_K, duv), NACRE_OK);
    EXPECT_NEAR(cct_K[0], 6503.5, 2.0);
    EXPECT_NEAR(duv[0], 0.0032, 1e-4);
    EXPECT_NEAR(cct_K[1], 2855.5, 2.0);
    EXPECT_NEAR(duv[1], 0.0, 1e-4);
    for (const int none : {2, 3}) EXPECT_TRUE(std::isnan(cct_K[none]) && std::isnan(duv[none]));
    EXPECT_EQ(error(nacre_colour_temperature(1, nullptr, cct_K, duv)), "XYZ: must not be null");
}

TEST(CapiReadSpectra, OfATable)
{
    const std::string_view csv = "# KIND: emission\n# TAGS: lamp, mine\nnm,a,b\n400,1,2\n500,3,4\n";
    nacre_spectra* spectra = nullptr;
    ASSERT_EQ(nacre_read_spectra(csv.data(), csv.size(), "two.csv", nullptr, 0.0, &spectra),
              NACRE_OK);
    ASSERT_EQ(nacre_spectra_count(spectra), 2U);
    nacre_spectrum second;
    const char* tags = nullptr;
    ASSERT_EQ(nacre_spectra_at(spectra, 1, &second, &tags), NACRE_OK);
    EXPECT_STREQ(second.kind, "emission");
    EXPECT_STREQ(tags, "lamp\nmine");
    ASSERT_EQ(second.count, 2U);
    EXPECT_EQ(second.wavelength_nm[1], 500.0);
    EXPECT_EQ(second.values[1], 4.0);
    EXPECT_EQ(error(nacre_spectra_at(spectra, 2, &second, nullptr)), "index: must be < 2 (got 2)");
    nacre_spectra_free(spectra);
    nacre_spectra_free(nullptr);
    EXPECT_EQ(nacre_spectra_count(nullptr), 0U);

    const std::string_view bad = "400 1\n300 2\n";
    const auto read = [&spectra](std::string_view text, const char* kind, double scale) {
        return nacre_read_spectra(text.data(), text.size(), "lamp.spd", kind, scale, &spectra);
    };
    EXPECT_EQ(error(read(bad, "", 0.0)).substr(0, 11), "lamp.spd:2:");

    const std::string_view dark = "400 1.7\n500 0.5\n";
    EXPECT_EQ(error(read(dark, "reflectance", 0.0)).substr(0, 48),
              "lamp.spd: values: must be ratios or per cent, an");
    EXPECT_EQ(error(read(dark, "colour", 0.0)).substr(0, 22), "kind: must be emission");
    EXPECT_EQ(error(read(dark, "", -1.0)).substr(0, 22), "scale: must be finite ");
    ASSERT_EQ(read(dark, "reflectance", 0.01), NACRE_OK);
    ASSERT_EQ(nacre_spectra_at(spectra, 0, &second, nullptr), NACRE_OK);
    EXPECT_STREQ(second.kind, "reflectance");
    EXPECT_EQ(second.values[0], 0.017);
    nacre_spectra_free(spectra);
}

class OwnEntries : public ::testing::Test {
protected:
    static nacre_spectrum spectrum(const char* key, const char* kind)
    {
        static const std::vector<double> nm{400.0, 700.0}, values{0.25, 1.5};
        return {.key = key,
                .name = "Mine",
                .kind = kind,
                .references = "measured",
                .licence = "CC0 1.0",
                .comments = nullptr,
                .count = 2,
                .wavelength_nm = nm.data(),
                .values = values.data()};
    }

    nacre::test::OwnLibrary library;
};

TEST_F(OwnEntries, SpectraAreAllKeptOrNone)
{
    const nacre_spectrum two[] = {spectrum("capi/lamp", "emission"), spectrum("../x", "emission")};
    EXPECT_NE(error(nacre_library_add_spectra(2, two, nullptr, 0)).find("../x: must be up to"),
              std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(library.folder() / "spectra"));

    const char* const tags[] = {"lamp\nmine"};
    ASSERT_EQ(nacre_library_add_spectra(1, two, tags, 0), NACRE_OK);
    nacre_spectrum found;
    ASSERT_EQ(nacre_library_spectrum("capi/lamp", &found), NACRE_OK);
    EXPECT_STREQ(found.references, "measured");
    EXPECT_EQ(found.values[1], 1.5);
    nacre_library_words words;
    ASSERT_EQ(nacre_library_words_of(NACRE_SPECTRA, "capi/lamp", &words), NACRE_OK);
    EXPECT_STREQ(words.tags, "lamp\nmine");

    EXPECT_NE(error(nacre_library_add_spectra(1, two, nullptr, 0)).find("is there already"),
              std::string::npos);
    EXPECT_EQ(nacre_library_add_spectra(1, two, nullptr, 1), NACRE_OK);
    const nacre_spectrum shipped = spectrum("lamp/hps", "emission");
    EXPECT_NE(error(nacre_library_add_spectra(1, &shipped, nullptr, 1)).find("comes with Nacre"),
              std::string::npos);
}

TEST_F(OwnEntries, SpectraMustSuitTheirKind)
{
    nacre_spectrum bright = spectrum("capi/bright", "glow");
    EXPECT_EQ(error(nacre_library_add_spectra(1, &bright, nullptr, 0)),
              "kind: must be emission or reflectance (got \"glow\") (item 0)");
    const double values[] = {0.25, 50.0};
    bright.kind = "reflectance";
    bright.values = values;
    EXPECT_EQ(error(nacre_library_add_spectra(1, &bright, nullptr, 0)).substr(0, 7), "values:");
}

TEST_F(OwnEntries, MediaFromTables)
{
    const std::string_view csv = "wavelength_nm,n,k\n400,1.5,0.1\n800,1.4,0\n";
    const auto add = [csv](int replace) {
        return nacre_library_add_medium("capi/film", csv.data(), csv.size(), "film.csv", "me",
                                        replace);
    };
    ASSERT_EQ(add(0), NACRE_OK);
    const double nm = 600.0;
    double n[2];
    ASSERT_EQ(nacre_library_index("capi/film", 1, &nm, n), NACRE_OK);
    EXPECT_NEAR(n[0], 1.45, 1e-12);
    EXPECT_NEAR(n[1], 0.05, 1e-12);
    EXPECT_NE(error(add(0)).find("is there already"), std::string::npos);
    EXPECT_EQ(add(1), NACRE_OK);
    const std::string_view stated =
        "REFERENCES: book\nDATA:\n  - type: formula 5\n"
        "    wavelength_range: 0.4 0.7\n    coefficients: 1.5 0.004 -2\n";
    EXPECT_EQ(error(nacre_library_add_medium("capi/glass", stated.data(), stated.size(), "g.yml",
                                             "me", 0)),
              "g.yml: REFERENCES: is stated already: leave the citation out");
}

}  // namespace
