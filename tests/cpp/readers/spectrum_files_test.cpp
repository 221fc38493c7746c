// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"

#include <algorithm>
#include <string>
#include <vector>

#include "nacre/core/limits.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

using Numbers = std::vector<double>;

TEST(CsvSpectra, ReadsNamesCommentsAndRows)
{
    const auto spectra = read_csv_spectra(
        "\xEF\xBB\xBF# NAME: Two lamps\r\n# KIND: emission\r\n# a note\r\n# TAGS: lamp, , new\r\n"
        "wavelength_nm,\"first\", second \r\n400,1,2\r\n\r\n410.5,+3e0,4\r\n",
        "lamps.csv");
    ASSERT_EQ(spectra.size(), 2u);
    EXPECT_EQ(spectra[0].name, "first");
    EXPECT_EQ(spectra[1].name, "second");
    EXPECT_EQ(spectra[1].kind, SpectrumKind::emission);
    EXPECT_EQ(spectra[1].tags, (std::vector<std::string>{"lamp", "new"}));
    EXPECT_EQ(spectra[1].samples.wavelengths_nm(), (Numbers{400, 410.5}));
    EXPECT_EQ(spectra[0].samples.values(), (Numbers{1, 3}));
    EXPECT_EQ(spectra[1].samples.values(), (Numbers{2, 4}));
}

TEST(CsvSpectra, ReadsOtherSeparatorsAndNoNames)
{
    for (const char* text : {"400;1\n500;0.5\n", "400\t1\n500\t0.5\n", "400 , 1\n500 , 0.5"}) {
        const auto spectra = read_csv_spectra(text, "x.csv");
        ASSERT_EQ(spectra.size(), 1u) << text;
        EXPECT_EQ(spectra[0].samples.values(), (Numbers{1, 0.5})) << text;
        EXPECT_FALSE(spectra[0].kind) << text;
    }
}

TEST(CsvSpectra, TakesMicrometres)
{
    const auto spectra = read_csv_spectra("wavelength_um,R\n0.4,1\n0.5,0.5\n", "x.csv");
    EXPECT_NEAR(spectra[0].samples.first_nm(), 400.0, 1e-9);
    EXPECT_INPUT_ERROR((void)read_csv_spectra("wavelength_nm,R\n0.4,1\n0.5,0.5\n", "x.csv"),
                       "x.csv:1: wavelength: must reach 30 nm; for µm the column must be called "
                       "wavelength_um (got 0.4 … 0.5)");
}

TEST(CsvSpectra, NamesEveryProblemWithItsLine)
{
    const std::string message = test::input_error_of(
        [] { (void)read_csv_spectra("wavelength_nm,R\n400,one\n500,1,2\n-300,nan\n", "x.csv"); });
    EXPECT_EQ(
        message,
        "x.csv:2: R: must be a finite number (got 'one')\n"
        "x.csv:3: must have 2 numbers as the rows before (got 3)\n"
        "x.csv:4: wavelength: must be > 0 and descending as before (got -300 nm after 400 nm)\n"
        "x.csv:4: R: must be a finite number (got 'nan')");
}

TEST(CsvSpectra, RefusesWhatIsNoTable)
{
    EXPECT_INPUT_ERROR((void)read_csv_spectra("", "x.csv"),
                       "x.csv: must have rows of a wavelength");
    EXPECT_INPUT_ERROR((void)read_csv_spectra("# KIND: emission\n", "x.csv"), "must have rows");
    EXPECT_INPUT_ERROR((void)read_csv_spectra("wavelength_nm,R\n400,1\n", "x.csv"),
                       "x.csv:1: must have at least two rows of numbers (got 1)");
    EXPECT_INPUT_ERROR((void)read_csv_spectra("400\n500\n", "x.csv"),
                       "columns after the wavelength");
    EXPECT_INPUT_ERROR((void)read_csv_spectra("# KIND: colour\n400,1\n500,1\n", "x.csv"),
                       "x.csv: KIND: must be emission or reflectance (got 'colour')");
    EXPECT_INPUT_ERROR(
        (void)read_csv_spectra("wl,n\n0.4,1\n0.5,1\n\nwl,k\n0.4,1\n0.5,1\n", "x.csv"),
        "x.csv:5: must have one table of spectra");
}

TEST(CsvSpectra, KeepsToItsLimits)
{
    std::string wide = "400";
    for (std::size_t i = 0; i <= kMaxSpectra; ++i) wide += ",1";
    EXPECT_INPUT_ERROR((void)read_csv_spectra(wide + "\n" + wide, "x.csv"),
                       "must have 1 … 10000 columns after the wavelength (got 10001)");

    std::string tall;
    for (std::size_t i = 1; i <= kMaxSamples; ++i) tall += std::to_string(i) + ",1\n";
    EXPECT_EQ(read_csv_spectra(tall, "x.csv")[0].samples.values().size(), kMaxSamples);
    EXPECT_INPUT_ERROR((void)read_csv_spectra(tall + "100001,1\n", "x.csv"),
                       "x.csv:100001: must have at most 100000 rows");

    EXPECT_INPUT_ERROR((void)read_csv_spectra(std::string(kMaxTextBytes + 1, '#'), "x.csv"),
                       "x.csv: must not be larger than 16777216 bytes");

    std::string wrong = "nm,a\n";
    for (int i = 0; i < 1000; ++i) wrong += "400,b\n";
    const std::string message =
        test::input_error_of([&] { (void)read_csv_spectra(wrong, "x.csv"); });
    EXPECT_EQ(std::ranges::count(message, '\n'), kMaxProblems - 1);
    EXPECT_TRUE(message.ends_with("; there is more that is wrong"));
}

TEST(LibrarySpectrum, IsWrittenAsItIsRead)
{
    const NamedSpectrum spectrum{.key = {},
                                 .name = "Leaf",
                                 .references = "A. Author,\n2020",
                                 .licence = "CC0 1.0",
                                 .comments = "",
                                 .tags = {"plant", "green"},
                                 .kind = SpectrumKind::reflectance,
                                 .samples = {{400, 500.25, 1.0 / 3 + 600}, {0.1, 1.0 / 3, 1e-17}}};
    const auto read = read_library_spectrum(write_library_spectrum(spectrum), "leaf.csv");
    EXPECT_EQ(read.name, "Leaf");
    EXPECT_EQ(read.references, "A. Author, 2020");
    EXPECT_EQ(read.licence, "CC0 1.0");
    EXPECT_EQ(read.tags, spectrum.tags);
    EXPECT_EQ(read.kind, spectrum.kind);
    EXPECT_EQ(read.samples.wavelengths_nm(), spectrum.samples.wavelengths_nm());
    EXPECT_EQ(read.samples.values(), spectrum.samples.values());
}

TEST(LibrarySpectrum, HasOneColumnOfAKind)
{
    EXPECT_INPUT_ERROR((void)read_library_spectrum("400,1\n500,1\n", "x.csv"),
                       "x.csv: KIND: is missing");
    EXPECT_INPUT_ERROR((void)read_library_spectrum("# KIND: emission\n400,1,1\n500,1,1\n", "x.csv"),
                       "x.csv: must have one column of values (got 2)");
    EXPECT_INPUT_ERROR((void)read_library_spectrum("# KIND: reflectance\n400,1\n500,43\n", "x.csv"),
                       "x.csv: value: a reflectance must be in [0, 2], 1 for all of the light "
                       "(got 1 … 43)");
    EXPECT_INPUT_ERROR((void)read_library_spectrum("# KIND: emission\n400,1\n500,-1\n", "x.csv"),
                       "an emission must be ≥ 0 (got -1)");
    EXPECT_INPUT_ERROR((void)read_library_spectrum("# KIND: emission\n400,0\n500,0\n", "x.csv"),
                       "an emission must be > 0 somewhere");
}

}  // namespace
}  // namespace nacre::spectral
