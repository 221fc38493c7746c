// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "nacre/core/file_io.h"
#include "nacre/core/resources.h"
#include "nacre/media/optical_constants.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

Medium parse(const std::string& text)
{
    return parse_refractiveindex_yaml(text, "test.yml");
}

std::string formula_yaml(int number, const std::string& range, const std::string& coefficients)
{
    return "DATA:\n  - type: formula " + std::to_string(number) +
           "\n    wavelength_range: " + range + "\n    coefficients: " + coefficients + "\n";
}

std::string table_yaml(const std::string& type, const std::string& rows)
{
    return "DATA:\n  - type: tabulated " + type + "\n    data: |\n" + rows;
}

// N-BK7 of SCHOTT, whose formula is tested in media/dispersion_formula_test.cpp.
TEST(Formula, IsReadWithItsRange)
{
    const Medium glass = parse(formula_yaml(
        2, "0.3 2.5", "0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653"));
    EXPECT_NEAR(glass.constants->at(587.6).real(), 1.5167984379050087, 1e-15);
    EXPECT_EQ(glass.constants->at(587.6).imag(), 0.0);
}

// Formula 4 with a fraction that is padded by zeros has no pole at 1 µm.
TEST(Formula, PaddedFractionIsNoPole)
{
    const Medium rutile = parse(formula_yaml(4, "0.43 1.53", "5.913 0.2441 0 0.0803 1 0 0 0 0"));
    EXPECT_NEAR(rutile.constants->at(1000.0).real(), std::sqrt(5.913 + 0.2441 / 0.9197), 1e-14);
}

TEST(Formula, CountsItsCoefficients)
{
    EXPECT_INPUT_ERROR(parse(formula_yaml(1, "0.2 1", "0 1 0.1 2")),
                       "test.yml:4: DATA[0].coefficients: formula 1 takes an odd number of "
                       "coefficients, 3 … 17 (got 4)");
    EXPECT_INPUT_ERROR(parse(formula_yaml(4, "0.2 1", "1 2 3 4 5 6 7")), "9 … 17 (got 7)");
    EXPECT_INPUT_ERROR(parse(formula_yaml(7, "0.2 1", "1 2 3")), "formula 7 takes 5 … 6");
    EXPECT_INPUT_ERROR(parse(formula_yaml(8, "0.2 1", "1 2 3 4 5")),
                       "formula 8 takes 4 coefficients (got 5)");
    EXPECT_INPUT_ERROR(parse(formula_yaml(9, "0.2 1", "1")), "formula 9 takes 6 coefficients");
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "0.2 1", "0 nan 1")), "must be finite (got nan)");
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "0.2 1", "0 one 1")), "must be numbers");
}

TEST(Formula, ChecksItsRange)
{
    const char* const wanted = "wavelength_range: must be two ascending wavelengths in µm";
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "1 0.2", "0 1 0.01")), wanted);
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "0.2", "0 1 0.01")), wanted);
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "0 1", "0 1 0.01")), wanted);
    EXPECT_INPUT_ERROR(parse(formula_yaml(2, "0.2 inf", "0 1 0.01")), wanted);
    const auto glass = parse(formula_yaml(2, "0.4 0.7", "0 1 0.01")).constants;
    EXPECT_EQ(glass->range_nm(), (std::array<double, 2>{400.0, 700.0}));
    EXPECT_NO_THROW((void)glass->at(400.0));
    EXPECT_NO_THROW((void)glass->at(700.0));
    EXPECT_INPUT_ERROR((void)glass->at(399.9), "must be within the data, 400 … 700 nm (got 399.9)");
    EXPECT_INPUT_ERROR((void)glass->at(std::nan("")), "(got nan)");
}

TEST(Formula, HasNoIndexBetweenPoleAndZero)
{
    const auto medium = parse(formula_yaml(2, "0.2 1", "0 1 0.3")).constants;
    EXPECT_INPUT_ERROR((void)medium->at(500.0), "give no index n > 0 at 500 nm");
}

TEST(Table, IsLinearInNAndK)
{
    const auto medium = parse(table_yaml("nk",
                                         "        0.4 1.0 0.5\n"
                                         "        0.5 2.0 0.1\n"
                                         "        0.6 1.5 0.3\n"))
                            .constants;
    EXPECT_EQ(medium->range_nm(), (std::array<double, 2>{400.0, 600.0}));
    EXPECT_EQ(medium->at(400.0), Complex(1.0, 0.5));
    EXPECT_EQ(medium->at(600.0), Complex(1.5, 0.3));
    EXPECT_COMPLEX_NEAR(medium->at(425.0), Complex(1.25, 0.4), 1e-15);
    EXPECT_COMPLEX_NEAR(medium->at(590.0), Complex(1.55, 0.28), 1e-15);
}

TEST(Table, NAndKMayStandApartAndShareTheRangeOfBoth)
{
    const std::string n = "  - type: tabulated n\n    data: |\n        0.3 1.5\n        0.9 1.7\n";
    const std::string k = "  - type: tabulated k\n    data: |\n        0.4 0.0\n        1.2 0.8\n";
    for (const auto& text : {"DATA:\n" + n + k, "DATA:\n" + k + n}) {
        const auto medium = parse(text).constants;
        EXPECT_EQ(medium->range_nm(), (std::array<double, 2>{400.0, 900.0}));
        EXPECT_COMPLEX_NEAR(medium->at(600.0), Complex(1.6, 0.2), 1e-15);
        EXPECT_INPUT_ERROR((void)medium->at(350.0), "400 … 900 nm (got 350)");
    }
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        0.3 1.5\n        0.4 1.6\n") +
                             "  - type: tabulated k\n    data: |\n        0.5 0.1\n"),
                       "n and k must have wavelengths in common");
    EXPECT_EQ(parse(table_yaml("n", "        0.5 1.5\n")).constants->at(500.0), Complex(1.5, 0.0));
}

TEST(Table, NamesTheLineOfEveryBadRow)
{
    const std::string text = "REFERENCES: |\n    x\n" + table_yaml("nk",
                                                                   "        0.4 1.0 0.5\n"
                                                                   "        0.5 -1 0.1\n"
                                                                   "        0.45 1.5 -0.3\n"
                                                                   "        0.6 1.5\n"
                                                                   "        0.7 x 0\n"
                                                                   "        0.8 nan 0\n"
                                                                   "        inf 1 nan\n");
    EXPECT_EQ(test::input_error_of([&] { parse(text); }),
              "test.yml:10: DATA[0].data: must be numbers (got '0.7 x 0')\n"
              "test.yml:7: DATA[0].data: n must be finite and > 0 (got -1)\n"
              "test.yml:9: DATA[0].data: must have 3 numbers a row (got 2)\n"
              "test.yml:11: DATA[0].data: n must be finite and > 0 (got nan)\n"
              "test.yml:12: DATA[0].data: wavelengths must be finite and > 0 (got inf)\n"
              "test.yml:12: DATA[0].data: k must be finite (got nan)");
}

TEST(Table, RefusesImpossibleNumbers)
{
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        0 1\n")), "must be finite and > 0 (got 0");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        -1 1\n")), "> 0 (got -1");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        inf 1\n")), "finite");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        0.4 0\n")), "n must be finite and > 0");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        0.4 1e999\n")), "must be numbers");
}

using Texts = std::vector<std::string>;

// As in Fe3O4/Querry, Ag/Yang, CdS/Treharne and Fe2O3/Querry-o of the database.
TEST(MendedTable, SaysWhatWasPutRight)
{
    const Medium sorted =
        parse(table_yaml("nk", "        0.4 1.0 0.5\n        0.6 1.5 0.3\n        0.5 2.0 0.1\n"));
    EXPECT_EQ(sorted.changes,
              Texts{"DATA[0].data: sorted by wavelength (1 row, the first in line 6)"});
    EXPECT_EQ(sorted.constants->at(500.0), Complex(2.0, 0.1));
    EXPECT_COMPLEX_NEAR(sorted.constants->at(550.0), Complex(1.75, 0.2), 1e-15);

    const Medium descending =
        parse(table_yaml("n", "        0.6 1.5\n        0.5 2.0\n        0.4 1.0\n"));
    EXPECT_EQ(descending.constants->range_nm(), (std::array<double, 2>{400.0, 600.0}));
    EXPECT_EQ(descending.changes,
              Texts{"DATA[0].data: sorted by wavelength (2 rows, the first in line 5)"});

    const Medium twice = parse(
        table_yaml("k", "        0.4 0.5\n        0.5 0.1\n        0.5 0.2\n        0.6 0.3\n") +
        table_yaml("n", "        0.3 1\n        0.7 1\n").substr(6));
    EXPECT_EQ(twice.changes, Texts{"DATA[0].data: second row of a repeated wavelength left out (1 "
                                   "row, the first in line 6)"});
    EXPECT_EQ(twice.constants->at(500.0), Complex(1.0, 0.1));

    const Medium noise = parse(table_yaml(
        "nk", "        0.4 1.0 0.5\n        0.5 2.0 -3.22e-17\n        0.6 1.5 -0.004\n"));
    EXPECT_EQ(noise.changes, Texts{"DATA[0].data: k < 0 taken as 0 (2 rows, the first in line 5, k "
                                   "down to -0.004)"});
    EXPECT_EQ(noise.constants->at(500.0), Complex(2.0, 0.0));
    EXPECT_EQ(noise.constants->at(600.0), Complex(1.5, 0.0));

    const Medium gain = parse(
        table_yaml("nk", "        0.4 1.0 0.5\n        0.5 2.0 -0.148\n        0.6 2.0 0.7\n"));
    EXPECT_EQ(gain.changes,
              Texts{"DATA[0].data: k < 0 left out (1 row, the first in line 5, k down to -0.148)"});
    EXPECT_COMPLEX_NEAR(gain.constants->at(500.0), Complex(1.5, 0.6), 1e-15);
    EXPECT_INPUT_ERROR(parse(table_yaml("nk", "        0.4 1 -1\n")),
                       "k must be ≥ 0 (got -1 here, and less than -0.005 in 1 of 1 rows)");

    EXPECT_TRUE(parse(table_yaml("n", "        0.4 1\n        0.5 1\n")).changes.empty());
}

// As in LaF3/Amotchkina: n to 400 nm, k in the infrared only, where it starts with 0.
TEST(MendedTable, IsClearBeyondAKThatEndsWithZero)
{
    const std::string n = formula_yaml(5, "0.4 12", "1.5 0 0");
    const auto with_k = [&](const std::string& rows) {
        return parse(n + table_yaml("k", rows).substr(6));
    };
    const Medium clear = with_k("        9 0\n        10 0.5\n        11 0\n");
    EXPECT_EQ(clear.constants->range_nm(), (std::array<double, 2>{400.0, 12000.0}));
    EXPECT_EQ(clear.constants->at(550.0), Complex(1.5, 0.0));
    EXPECT_COMPLEX_NEAR(clear.constants->at(9500.0), Complex(1.5, 0.25), 1e-12);
    EXPECT_EQ(clear.changes, (Texts{"k ends with 0 at 9000 nm and is 0 below that",
                                    "k ends with 0 at 11000 nm and is 0 above that"}));
    // Of one that ends otherwise nothing is known beyond.
    const Medium open = with_k("        9 0.1\n        10 0.5\n");
    EXPECT_EQ(open.constants->range_nm(), (std::array<double, 2>{9000.0, 10000.0}));
    EXPECT_TRUE(open.changes.empty());
}

// As in polyvinylpyrrolidone/Konig.
TEST(MendedTable, TakesTheFirstOfTwoThatStateNAlike)
{
    const Medium medium =
        parse(formula_yaml(5, "0.4 0.9", "1.5 0.01 -2") +
              table_yaml("nk", "        0.4 1.5625 0.5\n        0.9 1.5124 0.1\n").substr(6));
    EXPECT_EQ(medium.changes, Texts{"DATA[1]: n is stated twice and alike, the first counts"});
    EXPECT_COMPLEX_NEAR(medium.constants->at(650.0), Complex(1.5 + 0.01 / (0.65 * 0.65), 0.3),
                        1e-12);
}

TEST(Table, EndsOfTheRangeCanBeAskedInNanometres)
{
    // 1.68847 · 1000 / 1000 is not 1.68847.
    const auto medium =
        parse(table_yaml("n", "        0.211002 1.5\n        1.68847 1.6\n")).constants;
    const auto [first, last] = medium->range_nm();
    EXPECT_EQ(medium->at(first), Complex(1.5, 0.0));
    EXPECT_EQ(medium->at(last), Complex(1.6, 0.0));
    EXPECT_INPUT_ERROR((void)medium->at(std::nextafter(last, 1e9)), "must be within the data");
}

TEST(Table, ManyBadRowsAreNotAllListed)
{
    std::string rows;
    for (int i = 0; i < 1000; ++i) rows += "        bad row\n";
    const std::string text = test::input_error_of([&] { parse(table_yaml("n", rows)); });
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 49);
    EXPECT_TRUE(text.ends_with("there is more that is wrong"));
}

TEST(RefractiveIndexYaml, ReadsTextAndNames)
{
    const Medium medium = parse(
        "NAMES:\n  - Titanium dioxide, TiO<sub>2</sub>\n"
        "REFERENCES: |\n    A. Author.\n    <i>Journal</i> <b>1</b>, 2\n"
        "COMMENTS: |\n    film\n" +
        table_yaml("n", "        0.4 1.5\n"));
    EXPECT_EQ(medium.key, "test.yml");
    EXPECT_EQ(medium.name, "Titanium dioxide, TiO2");
    EXPECT_EQ(medium.references, "A. Author.\nJournal 1, 2");
    EXPECT_EQ(medium.comments, "film");
    EXPECT_EQ(parse(table_yaml("n", "        0.4 1.5\n")).name, "test.yml");
}

TEST(RefractiveIndexYaml, ReadsWhatEditorsAndOldToolsWrite)
{
    const std::string rows = "        0.4 1.5\n        0.7 1.25\n";
    const auto index = [](const std::string& text) { return parse(text).constants->at(550.0); };
    const auto with_comment = [&](const std::string& comment) {
        return "COMMENTS: \"" + comment + "\"\n" + table_yaml("n", rows);
    };
    const std::string plain = with_comment("Schott");
    std::string dos, utf16 = "\xff\xfe";
    for (const char c : plain) {
        dos += c == '\n' ? "\r\n" : std::string(1, c);
        utf16 += {c, '\0'};
    }
    for (const std::string& text : {plain, dos, utf16, "\xef\xbb\xbf" + plain, "---\n" + plain,
                                    "%YAML 1.2\n---\n" + plain, plain + "...\n---\nDATA: 1\n"}) {
        SCOPED_TRACE(text);
        EXPECT_DOUBLE_EQ(index(text).real(), 1.375);
        EXPECT_EQ(parse(text).comments, "Schott");
    }
    // Latin-1 in a comment, and control characters.
    EXPECT_EQ(parse(with_comment("M\xfcller")).comments, "M?ller");
    EXPECT_EQ(parse(with_comment("a\x01z")).comments, "a?z");
    EXPECT_EQ(parse(with_comment("M\xc3\xbcller")).comments, "M\xc3\xbcller");
    // One table under two names, and a name that is said twice.
    EXPECT_DOUBLE_EQ(
        index("X: &rows |\n" + rows + "DATA:\n  - type: tabulated n\n    data: *rows\nDATA: 7\n")
            .real(),
        1.375);
    EXPECT_EQ(parse("COMMENTS: ~\n" + table_yaml("n", rows)).comments, "");
    EXPECT_EQ(parse("COMMENTS: \"~\"\n" + table_yaml("n", rows)).comments, "~");
    // A list that holds itself.
    EXPECT_INPUT_ERROR(parse("DATA: &me [*me]\n"), "test.yml:1: DATA[0].type: is missing");
    EXPECT_INPUT_ERROR(parse(""), "test.yml: DATA: must be a list");
    EXPECT_INPUT_ERROR(parse("# nothing\n"), "test.yml: DATA: must be a list");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: ~\n"), "test.yml:2: DATA[0].type: is missing");
}

TEST(RefractiveIndexYaml, SaysWhatDataMustBe)
{
    const char* const list = "DATA: must be a list of tables and formulas";
    for (const char* text : {"", "x", "DATA:", "DATA: 1", "DATA: []", "[1, 2]", "NAMES: [a]", "~"})
        EXPECT_INPUT_ERROR(parse(text), list);
    EXPECT_INPUT_ERROR(parse("DATA:\n  - 1\n"), "test.yml:2: DATA[0].type: is missing");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: [a]\n"), "DATA[0].type: is missing");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: formula 10\n"),
                       "must be 'tabulated n', 'tabulated k', 'tabulated nk' or 'formula 1' … "
                       "'formula 9' (got 'formula 10')");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: formula 0\n"), "(got 'formula 0')");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: tabulated n\n"), "DATA[0].data: is missing");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: tabulated n\n    data: []\n"),
                       "DATA[0].data: is missing");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: tabulated n\n    data: ''\n"), "must have rows");
    EXPECT_INPUT_ERROR(parse("DATA:\n  - type: formula 2\n    coefficients: 0 1 1\n"),
                       "DATA[0].wavelength_range: is missing");
    EXPECT_INPUT_ERROR(parse(table_yaml("k", "        0.4 1.5\n")), "DATA: must state n");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        0.4 1\n") +
                             "  - type: tabulated nk\n    data: |\n        0.4 1.1 0\n"),
                       "DATA[1]: n is stated twice, and not alike: 1 and 1.1 at 0.4 µm");
    EXPECT_INPUT_ERROR(
        parse(table_yaml("n", "        0.4 1\n") + formula_yaml(5, "0.3 0.9", "1 0 0").substr(6)),
        "DATA[1]: n is stated twice");
}

TEST(RefractiveIndexYaml, RefusesWhatIsNotYaml)
{
    EXPECT_INPUT_ERROR(parse("DATA: [1, 2"), "test.yml:1: is not valid YAML");
    EXPECT_INPUT_ERROR(parse("a: b\nDATA:\n\t- type: x\n"), "test.yml:3: is not valid YAML");
    EXPECT_INPUT_ERROR(parse("a: 1\nDATA: *nothing\n"),
                       "test.yml:2: is not valid YAML: nothing is called 'nothing'");
    EXPECT_INPUT_ERROR(parse("a: 1\nDATA: \xef\xbf\xbf\n"), "test.yml:2: is not valid YAML");
    const std::string whole = table_yaml("n", "        0.4 1.5\n        0.5 1.6\n");
    for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
        try {  // a truncated file is refused or is a shorter table, never anything else
            const Medium medium = parse(whole.substr(0, length));
            EXPECT_GT(medium.constants->at(400.0).real(), 0.0);
        } catch (const InputError&) {
        }
    }
}

TEST(RefractiveIndexYaml, MutatedFilesAreReadOrRefused)
{
    std::mt19937 random(7);
    const auto below = [&random](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    constexpr std::string_view kBytes = "0123456789.eE+-:|[]{}&*!%@#'\"\\ \n\t\xff";
    for (const char* key : {"water/Daimon-20C", "Fe/Johnson", "SiO/Hass"}) {
        const auto original = find_resource("optical_constants/" + std::string(key) + ".yml");
        ASSERT_TRUE(original.has_value());
        int refused = 0;
        for (int i = 0; i < 300; ++i) {
            std::string text(*original);
            for (std::size_t edit = 0; edit <= below(8); ++edit)
                text[below(text.size())] = kBytes[below(kBytes.size())];
            try {
                (void)parse(text).constants->at(587.6);
            } catch (const InputError& error) {
                ++refused;
                EXPECT_TRUE(std::string_view(error.what()).starts_with("test.yml")) << error.what();
            }
        }
        EXPECT_GT(refused, 30) << key;
    }
}

TEST(RefractiveIndexYaml, SurvivesHostileInput)
{
    EXPECT_INPUT_ERROR(parse(std::string(kMaxTextBytes + 1, ' ')),
                       "must not be larger than 16777216 bytes");
    for (const char open : {'[', '{'})
        EXPECT_INPUT_ERROR(parse("DATA: " + std::string(200000, open)),
                           "must not be nested deeper than 64 levels");
    const auto nested = [](std::size_t lists) {
        return "X: " + std::string(lists, '[') + std::string(lists, ']') + "\n";
    };
    EXPECT_INPUT_ERROR(parse(nested(63)), "DATA: must be");
    EXPECT_INPUT_ERROR(parse(nested(64)), "must not be nested deeper than 64 levels");
    EXPECT_INPUT_ERROR(parse(table_yaml("n", "        \xc3\x84" + std::string(200, 'x') + "\n")),
                       "must be numbers (got 'Ä" + std::string(58, 'x') + "…')");
    EXPECT_INPUT_ERROR(parse(std::string("\0\xff\xfe", 3)), "test.yml");
    // Ten levels of ten aliases each: ten thousand million nodes if they were copied.
    std::string laughs = "l0: &l0 [a, a, a, a, a, a, a, a, a, a]\n";
    for (int i = 1; i < 10; ++i) {
        const std::string before = "*l" + std::to_string(i - 1);
        laughs += "l" + std::to_string(i) + ": &l" + std::to_string(i) + " [" + before;
        for (int j = 1; j < 10; ++j) laughs += ", " + before;
        laughs += "]\n";
    }
    EXPECT_INPUT_ERROR(parse(laughs + "DATA: *l9\n"), "DATA[0].type: is missing");
}

}  // namespace
}  // namespace nacre::spectral
