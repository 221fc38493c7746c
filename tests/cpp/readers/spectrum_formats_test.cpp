// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "nacre/core/limits.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

using Numbers = std::vector<double>;

TEST(Spd, ReadsPairs)
{
    const auto spectra = read_spd("# of a lamp\n\n 400 0.5 # here\r\n410\t1e-1\n420,+2", "x.spd");
    ASSERT_EQ(spectra.size(), 1u);
    EXPECT_EQ(spectra[0].samples.wavelengths_nm(), (Numbers{400, 410, 420}));
    EXPECT_EQ(spectra[0].samples.values(), (Numbers{0.5, 0.1, 2}));
    EXPECT_FALSE(spectra[0].kind);
}

TEST(Spd, NamesEveryProblemWithItsLine)
{
    EXPECT_EQ(test::input_error_of(
                  [] { (void)read_spd("400 1\n400 x\n500\n600 inf\n-1 1 # back\n", "x.spd"); }),
              "x.spd:2: value: must be a finite number (got 'x')\n"
              "x.spd:2: wavelength: must be > 0 and ascending (got 400 nm after 400 nm)\n"
              "x.spd:3: must be a wavelength and a value (got 1 words)\n"
              "x.spd:4: value: must be a finite number (got 'inf')\n"
              "x.spd:5: wavelength: must be > 0 and ascending (got -1 nm after 600 nm)");
    EXPECT_INPUT_ERROR((void)read_spd("", "x.spd"), "x.spd: must have at least two samples");
    EXPECT_INPUT_ERROR((void)read_spd("400 1\n", "x.spd"), "(got 1)");
}

TEST(Spd, KeepsToItsLimits)
{
    std::string tall;
    for (std::size_t i = 1; i <= kMaxSamples + 1; ++i) tall += std::to_string(i) + " 1\n";
    EXPECT_INPUT_ERROR((void)read_spd(tall, "x.spd"),
                       "x.spd:100001: must have at most 100000 samples");
    EXPECT_INPUT_ERROR((void)read_spd(std::string(kMaxTextBytes + 1, ' '), "x.spd"),
                       "must not be larger");
}

std::string spdx(const std::string& distribution, const std::string& before = "")
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + before +
           "<IESTM2714 xmlns=\"iestm2714\" version=\"1.0\">\n"
           "<Header><Manufacturer>Maker</Manufacturer><Description>A &amp; B\nlamp</Description>"
           "<Comments>none</Comments><ReportDate>2015-01-31</ReportDate></Header>\n"
           "<SpectralDistribution>\n" +
           distribution + "</SpectralDistribution></IESTM2714>\n";
}

const std::string kData =
    "<SpectralData wavelength=\"400\">0.25</SpectralData>\n"
    "<SpectralData wavelength=\" 410.5 \"> 1e0 </SpectralData>\n";

TEST(Spdx, ReadsHeaderQuantityAndSamples)
{
    const auto read =
        read_spdx(spdx("<SpectralQuantity>flux</SpectralQuantity>\n" + kData), "x.spdx");
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].name, "A & B lamp");
    EXPECT_EQ(read[0].references, "Maker, 2015-01-31");
    EXPECT_EQ(read[0].comments, "none");
    EXPECT_EQ(read[0].kind, SpectrumKind::emission);
    EXPECT_EQ(read[0].samples.wavelengths_nm(), (Numbers{400, 410.5}));
    EXPECT_EQ(read[0].samples.values(), (Numbers{0.25, 1}));

    const auto kind = [](const std::string& quantity) {
        return read_spdx(spdx("<SpectralQuantity>" + quantity + "</SpectralQuantity>" + kData), "x")
            .front()
            .kind;
    };
    EXPECT_EQ(kind("R-Factor"), SpectrumKind::reflectance);
    EXPECT_EQ(kind("transmittance"), SpectrumKind::reflectance);
    EXPECT_EQ(kind("Radiance"), SpectrumKind::emission);
    EXPECT_EQ(kind("other"), std::nullopt);
}

TEST(Spdx, ReadsPrefixedNames)
{
    const std::string text =
        "<i:IESTM2714 xmlns:i='iestm2714'><i:SpectralDistribution>"
        "<i:SpectralData wavelength='400'>1</i:SpectralData>"
        "<i:SpectralData wavelength='500'>2</i:SpectralData>"
        "</i:SpectralDistribution></i:IESTM2714>";
    EXPECT_EQ(read_spdx(text, "x.spdx")[0].samples.values(), (Numbers{1, 2}));
}

TEST(Spdx, NamesEveryProblemWithItsLine)
{
    EXPECT_EQ(test::input_error_of([] {
                  (void)read_spdx(spdx("<SpectralData wavelength=\"400\">x</SpectralData>\n"
                                       "<SpectralData>1</SpectralData>\n"
                                       "<SpectralData wavelength=\"300\">1</SpectralData>\n"),
                                  "x.spdx");
              }),
              "x.spdx:6: value: must be a finite number (got 'x')\n"
              "x.spdx:7: SpectralData.wavelength: is missing\n"
              "x.spdx:8: wavelength: must be > 0 and ascending (got 300 nm after 400 nm)");
    EXPECT_INPUT_ERROR((void)read_spdx("<a/>", "x.spdx"),
                       "x.spdx: IESTM2714.SpectralDistribution: is missing");
    EXPECT_INPUT_ERROR((void)read_spdx("<a>\n<b>\n", "x.spdx"), "is not valid XML");
    EXPECT_INPUT_ERROR((void)read_spdx("", "x.spdx"), "x.spdx:1: is not valid XML");
    EXPECT_INPUT_ERROR((void)read_spdx(spdx(""), "x.spdx"), "must have at least two samples");
}

TEST(Spdx, RefusesEntitiesOfTheFileAndDepth)
{
    std::string bomb = "<!DOCTYPE l [<!ENTITY a \"aaaaaaaaaa\">";
    for (char c = 'b'; c < 'k'; ++c)
        bomb += std::string("<!ENTITY ") + c + " \"&" + static_cast<char>(c - 1) + ";&" +
                static_cast<char>(c - 1) + ";\">";
    EXPECT_INPUT_ERROR((void)read_spdx(spdx(kData, bomb + "]>\n"), "x.spdx"),
                       "must not have a document type");
    EXPECT_INPUT_ERROR(
        (void)read_spdx(spdx(kData, "<!DOCTYPE l SYSTEM \"file:///etc/passwd\">\n"), "x.spdx"),
        "must not have a document type");

    const auto nested = [](int depth) {
        std::string text;
        for (int i = 2; i < depth; ++i) text += "<x>";
        for (int i = 2; i < depth; ++i) text += "</x>";
        return spdx(kData + text);
    };
    EXPECT_NO_THROW((void)read_spdx(nested(kMaxXmlDepth), "x.spdx"));
    EXPECT_INPUT_ERROR((void)read_spdx(nested(kMaxXmlDepth + 1), "x.spdx"),
                       "is nested deeper than 16 levels");
    EXPECT_INPUT_ERROR((void)read_spdx(nested(200'000), "x.spdx"), "is nested deeper");
}

const std::string kChart =
    "CGATS.17\nORIGINATOR \"Some body\"\n# a comment\nDESCRIPTOR \"Two patches\"\n"
    "NUMBER_OF_FIELDS 4\nBEGIN_DATA_FORMAT\nSAMPLE_ID SAMPLE_NAME SPECTRAL_NM410 "
    "SPECTRAL_NM400\nEND_DATA_FORMAT\nNUMBER_OF_SETS 2\nBEGIN_DATA\n";

TEST(Cgats, ReadsASpectrumOfEachSet)
{
    const auto spectra =
        read_cgats(kChart + "1 \"red patch\" 0.5 0.25\n2 green\n 0.75 1\nEND_DATA\n", "x.cgats");
    ASSERT_EQ(spectra.size(), 2u);
    EXPECT_EQ(spectra[0].name, "red patch");
    EXPECT_EQ(spectra[1].name, "green");
    EXPECT_EQ(spectra[0].references, "Some body");
    EXPECT_EQ(spectra[0].comments, "Two patches");
    EXPECT_EQ(spectra[0].kind, SpectrumKind::reflectance);
    EXPECT_EQ(spectra[0].samples.wavelengths_nm(), (Numbers{400, 410}));  // sorted
    EXPECT_EQ(spectra[0].samples.values(), (Numbers{0.25, 0.5}));
    EXPECT_EQ(spectra[1].samples.values(), (Numbers{1, 0.75}));
}

TEST(Cgats, ReadsOtherNamesOfFields)
{
    for (const char* fields : {"SPECTRAL_400 SPECTRAL_410", "nm400 nm410",
                               "SPECTRAL_DEC400 "
                               "SPECTRAL_DEC410",
                               "SPECTRAL_NM_400 SPECTRAL_NM_410", "NM_400.0 NM_410.0"}) {
        const std::string text = std::string("ISO28178\nBEGIN_DATA_FORMAT\nSAMPLE_ID ") + fields +
                                 "\nEND_DATA_FORMAT\nBEGIN_DATA\nA1 0.5 0.25\nEND_DATA";
        const auto spectra = read_cgats(text, "x.txt");
        EXPECT_EQ(spectra[0].samples.values(), (Numbers{0.5, 0.25})) << fields;
        EXPECT_EQ(spectra[0].name, "A1");
    }
    const auto percent = read_cgats(
        "CGATS.17\nBEGIN_DATA_FORMAT\nSPECTRAL_PCT400 SPECTRAL_PCT410\nEND_DATA_FORMAT\n"
        "BEGIN_DATA\n50 25\nEND_DATA",
        "x.txt");
    EXPECT_EQ(percent[0].samples.values(), (Numbers{0.5, 0.25}));
}

TEST(Cgats, ReadsSpectraOfArgyll)
{
    const auto spectra = read_cgats(
        "SPECT  \n\nDESCRIPTOR \"Argyll spectral power\"\nKEYWORD \"SPECTRAL_NORM\"\n"
        "SPECTRAL_NORM \"100.0\"\nKEYWORD \"MEAS_TYPE\"\nMEAS_TYPE \"EMISSION\"\n"
        "BEGIN_DATA_FORMAT\nSPEC_400 SPEC_410\nEND_DATA_FORMAT\nBEGIN_DATA\n100 50\nEND_DATA\n",
        "lamp.sp");
    EXPECT_EQ(spectra[0].kind, SpectrumKind::emission);
    EXPECT_EQ(spectra[0].samples.values(), (Numbers{1, 0.5}));
    EXPECT_EQ(spectra[0].name, "Argyll spectral power");
}

TEST(Cgats, IsAsLongAsItSays)
{
    const std::string row = "1 red 0.5 0.25\n";
    EXPECT_INPUT_ERROR((void)read_cgats(kChart + row + "END_DATA\n", "x"),
                       "x:10: NUMBER_OF_SETS: must be 1, what there is (got 2)");
    EXPECT_INPUT_ERROR((void)read_cgats(kChart + row + row + row + "END_DATA\n", "x"),
                       "NUMBER_OF_SETS: must be 3, what there is (got 2)");
    std::string other = kChart;
    other.replace(other.find("FIELDS 4"), 8, "FIELDS 5");
    EXPECT_INPUT_ERROR((void)read_cgats(other + row + row + "END_DATA\n", "x"),
                       "NUMBER_OF_FIELDS: must be 4, what there is (got 5)");
    // A second table without a number of its own.
    const auto spectra =
        read_cgats(kChart + row + row + "END_DATA\nBEGIN_DATA\n" + row + "END_DATA\n", "x");
    EXPECT_EQ(spectra.size(), 3u);
}

// Each of these files has one fault, and one message.
TEST(Messages, OfOneFaultAreOne)
{
    struct Case {
        const char* file;
        std::string text, message;
    };
    const std::string row = "1 red 0.5 0.25\n";
    std::string no_fields = kChart, twice = kChart;
    no_fields.replace(no_fields.find("SPECTRAL_NM410 SPECTRAL_NM400"), 29, "RGB_R RGB_G");
    twice.replace(twice.find("NM410"), 5, "NM400");
    std::string tall = "nm,a\n",
                wide = "BEGIN_DATA_FORMAT\nnm400 nm410\nEND_DATA_FORMAT\nBEGIN_DATA\n";
    for (std::size_t i = 1; i <= kMaxSamples + 60; ++i) tall += std::to_string(100 + i) + ",1\n";
    for (std::size_t i = 0; i <= kMaxSpectra + 60; ++i) wide += "1 1\n";
    for (const auto& [file, text, message] : {
             Case{"x.cgats", no_fields + row + row + "END_DATA\n",
                  "x.cgats:6: BEGIN_DATA_FORMAT: must have two or more fields such as "
                  "SPECTRAL_NM380"},
             Case{"x.cgats", twice + row + row + "END_DATA\n",
                  "x.cgats:6: BEGIN_DATA_FORMAT: must have 400 nm once only"},
             // A word too few or too many ends with its line, and says nothing of how many there
             // are.
             Case{"x.cgats", kChart + row + "2 blue 0.5\n" + row + "END_DATA\n",
                  "x.cgats:12: must have 4 words as there are fields (got 3)"},
             Case{"x.cgats", kChart + row + "2 dark blue 0.5 0.25\nEND_DATA\n",
                  "x.cgats:12: must have 4 words as there are fields (got 5)"},
             Case{"x.cgats", kChart + row + "2 blue 0.5 x\n" + row + "END_DATA\n",
                  "x.cgats:12: 400 nm: must be a finite number (got 'x')"},
             Case{"x.cgats", wide + "END_DATA\n",
                  "x.cgats:10005: must have at most 10000 sets of data"},
             Case{"x.csv", tall, "x.csv:100002: must have at most 100000 rows"},
             Case{"x.csv", "nm,a\n400,1\nx,1\n420,1\n",
                  "x.csv:3: wavelength: must be a finite number (got 'x')"},
             Case{"x.csv", "nm,a\nx,1\n420,1\n",
                  "x.csv:2: wavelength: must be a finite number (got 'x')"},
             Case{"x.csv", "nm,a\n400,1\n500\n",
                  "x.csv:3: must have 2 numbers as the rows before (got 1)"},
             Case{"x.spd", "400 1\n500\n",
                  "x.spd:2: must be a wavelength and a value (got 1 words)"},
             Case{"x.spd", "400 1\nx 1\n420 1\n",
                  "x.spd:2: wavelength: must be a finite number (got 'x')"},
             Case{"x.spdx", spdx("<SpectralData>1</SpectralData>"),
                  "x.spdx:6: SpectralData.wavelength: is missing"},
         })
        EXPECT_EQ(test::input_error_of(
                      [&, &text = text, &file = file] { (void)read_spectra(text, file); }),
                  message);
}

TEST(Messages, ShowWhatAUserWrote)
{
    // "λ" in UTF-8; a lone byte of Latin-1; ESC and its C1 form; what is long is cut between
    // letters.
    for (const auto& [cell, shown] :
         {std::pair<std::string, std::string>{"\xCE\xBB (nm)", "λ (nm)"},
          {"5\xB5m", "5?m"},
          {"a\x1B[1m", "a?[1m"},
          {"a\xC2\x9B"
           "1m",
           "a?1m"},
          {std::string(59, 'x') + "\xCE\xBBy", std::string(59, 'x') + "λ…"},
          {std::string(60, 'x'), std::string(60, 'x')}})
        EXPECT_INPUT_ERROR((void)read_csv_spectra("nm,a\n400," + cell + "\n500,1\n", "x"),
                           "(got '" + shown + "')");
}

TEST(Cgats, ReadsSetsOverSeveralLines)
{
    const auto spectra = read_cgats(kChart + "1\n red 0.5\n0.25 2 blue\n0.75 1\nEND_DATA\n", "x");
    ASSERT_EQ(spectra.size(), 2U);
    EXPECT_EQ(spectra[0].samples.values(), (Numbers{0.25, 0.5}));
    EXPECT_EQ(spectra[1].samples.values(), (Numbers{1, 0.75}));
}

TEST(Cgats, NamesEveryProblemWithItsLine)
{
    EXPECT_EQ(test::input_error_of([] {
                  (void)read_cgats(kChart + "1 a x 0.25\n2 b 0.75 nan\n3 c\nEND_DATA\n", "x.cgats");
              }),
              "x.cgats:11: 410 nm: must be a finite number (got 'x')\n"
              "x.cgats:12: 400 nm: must be a finite number (got 'nan')\n"
              "x.cgats:13: must have 4 words as there are fields (got 2)");
    EXPECT_INPUT_ERROR((void)read_cgats("", "x"), "x: BEGIN_DATA: must have sets of data");
    EXPECT_INPUT_ERROR((void)read_cgats(kChart, "x"), "x:10: BEGIN_DATA: must end with END_DATA");
    EXPECT_INPUT_ERROR((void)read_cgats("BEGIN_DATA\n1 2\nEND_DATA", "x"),
                       "must come after BEGIN_DATA_FORMAT");
    EXPECT_INPUT_ERROR(
        (void)read_cgats("BEGIN_DATA_FORMAT\nRGB_R RGB_G\nEND_DATA_FORMAT\n", "x"),
        "x:1: BEGIN_DATA_FORMAT: must have two or more fields such as SPECTRAL_NM380");
    EXPECT_INPUT_ERROR(
        (void)read_cgats("BEGIN_DATA_FORMAT\nnm400 NM_400 nm410\nEND_DATA_FORMAT\n", "x"),
        "must have 400 nm once only");
    EXPECT_INPUT_ERROR((void)read_cgats("BEGIN_DATA_FORMAT\nnm400 nm410", "x"),
                       "must end with END_DATA_FORMAT");
}

TEST(Cgats, KeepsToItsLimits)
{
    std::string many = "BEGIN_DATA_FORMAT\nnm400 nm410\nEND_DATA_FORMAT\nBEGIN_DATA\n";
    for (std::size_t i = 0; i <= kMaxSpectra; ++i) many += "1 1\n";
    EXPECT_INPUT_ERROR((void)read_cgats(many + "END_DATA\n", "x"),
                       "must have at most 10000 sets of data");
    std::string wide = "BEGIN_DATA_FORMAT\n";
    for (std::size_t i = 0; i <= kMaxSamples; ++i) wide += "nm" + std::to_string(i + 1) + " ";
    EXPECT_INPUT_ERROR((void)read_cgats(wide, "x"), "must have at most 100000 fields");
}

std::string cgats_of(const std::string& fields, const std::string& row, const std::string& top = "")
{
    return "CGATS.17\n" + top + "BEGIN_DATA_FORMAT\n" + fields + "\nEND_DATA_FORMAT\nBEGIN_DATA\n" +
           row + "\nEND_DATA\n";
}

// A black patch in per cent has the numbers of a fluorescent colour in ratios.
TEST(PerCent, IsNotTakenForRatiosInAnyFormat)
{
    struct Case {
        const char* file;
        std::string text;
    };
    const std::string argyll = "SPEC_400 SPEC_410";
    for (const auto& [file, text] :
         {Case{"x.cgats", cgats_of("SPECTRAL_NM400 SPECTRAL_NM410", "1.7 0.5")},
          Case{"x.cgats", cgats_of("nm400 nm410", "1.7 0.5")},
          Case{"x.sp", cgats_of(argyll, "1.7 0.5")}, Case{"x.spd", "400 1.7\n410 0.5\n"},
          Case{"x.csv", "400,1.7\n410,0.5\n"}, Case{"x.csv", "nm,a,b\n400,0.9,1.7\n410,0.9,0.5\n"},
          Case{"x.spdx", spdx("<SpectralQuantity>R-Factor</SpectralQuantity>\n"
                              "<SpectralData wavelength=\"400\">1.7</SpectralData>\n"
                              "<SpectralData wavelength=\"410\">0.5</SpectralData>\n")}}) {
        const auto read = [&, &file = file, &text = text](std::optional<double> scale) {
            return read_spectra(text, file, {SpectrumKind::reflectance, scale})
                .back()
                .samples.values();
        };
        EXPECT_INPUT_ERROR((void)read({}),
                           "must be ratios or per cent, and the file does not say which (got 0.5 … "
                           "1.7): give a scale, 0.01 for per cent, 1 for ratios");
        EXPECT_EQ(read(1.0), (Numbers{1.7, 0.5})) << text;
        EXPECT_EQ(read(0.01), (Numbers{1.7 * 0.01, 0.5 * 0.01})) << text;
        EXPECT_NO_THROW((void)read_spectra(text, file, {SpectrumKind::emission, {}})) << text;
    }
}

TEST(PerCent, IsReadWhereTheFileSaysSo)
{
    const auto read = [](const std::string& text) {
        return read_spectra(text, "x.cgats").front().samples.values();
    };
    EXPECT_EQ(read(cgats_of("SPECTRAL_PCT400 SPECTRAL_PCT410", "1.7 1.2")),
              (Numbers{1.7 * 0.01, 1.2 * 0.01}));
    EXPECT_EQ(read(cgats_of("SPECTRAL_DEC400 SPECTRAL_DEC410", "1.5 0.5")), (Numbers{1.5, 0.5}));
    EXPECT_EQ(read(cgats_of("SPEC_400 SPEC_410", "1.5 50", "SPECTRAL_NORM \"100\"\n")),
              (Numbers{1.5 * 0.01, 50 * 0.01}));
    EXPECT_EQ(read(cgats_of("SPEC_400 SPEC_410", "1.5 0.5", "SPECTRAL_NORM 1\n")),
              (Numbers{1.5, 0.5}));
    // Of one field nothing is known.
    EXPECT_INPUT_ERROR((void)read(cgats_of("SPECTRAL_PCT400 SPECTRAL_NM410", "1.7 1.2")),
                       "must be ratios or per cent");
    // Whoever writes KIND writes what a library holds.
    EXPECT_EQ(read_spectra("# KIND: reflectance\n400,1.5\n500,0.5\n", "x.csv")[0].samples.values(),
              (Numbers{1.5, 0.5}));
}

TEST(PerCent, NamesEveryPatch)
{
    const std::string text =
        cgats_of("SAMPLE_NAME nm400 nm410", "white 96 97\nblack 1.2 1.7\nred 0.5 1");
    EXPECT_EQ(
        test::input_error_of([&] { (void)read_spectra(text, "c.txt"); }),
        "c.txt: white: must be ratios or per cent, and the file does not say which (got 96 … 97): "
        "give a scale, 0.01 for per cent, 1 for ratios above 1 (--scale of nacre library import, "
        "scale= in Python)\n"
        "c.txt: black: must be ratios or per cent, and the file does not say which (got 1.2 … "
        "1.7): "
        "give a scale, 0.01 for per cent, 1 for ratios above 1 (--scale of nacre library import, "
        "scale= in Python)");
}

// Fluorescence moves light; it makes none.
TEST(Reflectance, IsNotAboveOneEverywhere)
{
    const Spectrum above({400, 700}, {1.2, 1.7}), once({400, 700}, {1.0, 1.7});
    EXPECT_EQ(kind_problem(above, SpectrumKind::reflectance),
              "a reflectance must be ≤ 1 somewhere, 1 for all of the light (got 1.2 … 1.7)");
    EXPECT_EQ(kind_problem(once, SpectrumKind::reflectance), std::nullopt);
    EXPECT_EQ(kind_problem(above, SpectrumKind::emission), std::nullopt);
    EXPECT_INPUT_ERROR((void)read_library_spectrum("# KIND: reflectance\n400,1.2\n700,1.7\n", "x"),
                       "must be ≤ 1 somewhere");
}

TEST(SpectrumFormat, FollowsFromExtensionOrContent)
{
    EXPECT_EQ(spectrum_format("", "x.csv"), SpectrumFormat::csv);
    EXPECT_EQ(spectrum_format("<a/>", "x.spd"), SpectrumFormat::spd);
    EXPECT_EQ(spectrum_format("# c\n400 1\n", "x.txt"), SpectrumFormat::spd);
    EXPECT_EQ(spectrum_format("# c\n400,1\n", "x.txt"), SpectrumFormat::csv);
    EXPECT_EQ(spectrum_format("400\t1\n", "x"), SpectrumFormat::csv);
    EXPECT_EQ(spectrum_format("\n<?xml?>", "x.xml"), SpectrumFormat::spdx);
    EXPECT_EQ(spectrum_format(kChart, "x.txt"), SpectrumFormat::cgats);
    EXPECT_EQ(spectrum_format("", "x"), SpectrumFormat::csv);
    EXPECT_EQ(read_spectra("400 1\n500 2\n", "x")[0].samples.values(), (Numbers{1, 2}));
    EXPECT_EQ(read_spectra("400,1,2\n500,2,3\n", "x").size(), 2u);
}

TEST(Texts, ComeAsUtf8OnOneLine)
{
    // "é" in UTF-8; a lone byte of Latin-1; an overlong slash; a surrogate.
    const auto spectra = read_csv_spectra(
        "# NAME: caf\xC3\xA9 caf\xE9 \xC0\xAF \xED\xA0\x80\x01z\n400,1\n500,1\n", "x.csv");
    EXPECT_EQ(spectra[0].name, "café caf? ?? ??? z");
}

}  // namespace
}  // namespace nacre::spectral
