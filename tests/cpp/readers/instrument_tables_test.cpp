// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "nacre/media/optical_constants.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

using Numbers = std::vector<double>;

/// Little-endian with a mark, or as asked.
std::string utf16(std::u16string_view text, bool big_endian = false, bool marked = true)
{
    std::string bytes;
    const auto add = [&](char16_t unit) {
        const char low = static_cast<char>(unit & 0xFFU), high = static_cast<char>(unit >> 8U);
        bytes += big_endian ? high : low;
        bytes += big_endian ? low : high;
    };
    if (marked) add(u'\uFEFF');
    for (const char16_t unit : text) add(unit);
    return bytes;
}

// 400 nm: 0.5, 500 nm: 0.25, however it is written.
TEST(InstrumentTable, ReadsWhatIsUnambiguous)
{
    for (const std::string& text : {
             std::string("400;0,5\n500;0,25\n"),
             std::string("400,0\t0,5\n500,0\t0,25\n"),
             std::string("400 0,5\n500 0,25\n"),
             std::string("\"400,0\",\"0,5\"\n\"500,0\",\"0,25\"\n"),
             std::string("  400   0.5\n  500   0.25  \n"),
             std::string("400;0.5;\n500;0.25;\n;;\n"),
             std::string("Wavelength(nm),R,,\n400,0.5,,\n500,0.25,,\n,,,\n"),
             std::string("500;0,25\n400;0,5\n"),
             std::string("Wavelength(nm);R\n400;0,5\n500;0,25\n"),
             std::string("\xCE\xBB (nm);R\n400;0,5\n500;0,25\n"),
             std::string("\xCE\xBB / \xC2\xB5m;R\n0,4;0,5\n0,5;0,25\n"),
             std::string("Wavelength [\xB5m],R\n0.4,0.5\n0.5,0.25\n"),
             std::string("Wellenl\xC3\xA4nge in nm;R\n400;0,5\n500;0,25\n"),
             std::string("WL,R\n400,0.5\n500,0.25\n"),
             std::string("wl,R\n0.4,0.5\n0.5,0.25\n"),
             std::string("lambda_nm,R\n400,0.5\n500,0.25\n"),
             std::string("LAMBDA (\xC3\x85),R\n4000,0.5\n5000,0.25\n"),
             std::string("nm R\n400 0.5\n500 0.25\n"),
             std::string("Wavelength (nm) R (%)\n400 50\n500 25\n"),
             std::string("Wavelength nm;%R\n400;50\n500;25\n"),
             std::string("nm,Reflectance [%]\n400,50\n500,25\n"),
             std::string("nm,reflectance_percent\n500,25\n400,50\n"),
             utf16(u"\u03BB (nm);R\r\n400;0,5\r\n500;0,25\r\n"),
             utf16(u"Wavelength (nm)\tR (%)\n400\t50\n500\t25\n", true),
             utf16(u"400,0.5\n500,0.25\n", false, false),
             utf16(u"400 0.5\n500 0.25\n", true, false),
         }) {
        const auto spectra = read_spectra(text, "table.txt");
        ASSERT_EQ(spectra.size(), 1U) << text;
        const Spectrum& samples = spectra.front().samples;
        for (const std::size_t i : {0U, 1U}) {
            EXPECT_NEAR(samples.wavelengths_nm().at(i), Numbers({400, 500}).at(i), 1e-9) << text;
            EXPECT_NEAR(samples.values().at(i), Numbers({0.5, 0.25}).at(i), 1e-12) << text;
        }
    }
}

TEST(InstrumentTable, NamesColumnsWithoutTheirUnit)
{
    const auto spectra =
        read_spectra("nm;R (%);%T;a_pct;b percent;%;x\n400;1;2;3;4;5;1\n500;1;2;3;4;5;1\n", "t.csv",
                     {SpectrumKind::reflectance, {}});
    ASSERT_EQ(spectra.size(), 6U);
    const std::vector<std::string> names = {"R", "T", "a", "b", "", "x"};
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
        EXPECT_EQ(spectra[i].name, names[i]);
        EXPECT_NEAR(spectra[i].samples.values()[0], 0.01 * static_cast<double>(i + 1), 1e-15);
    }
}

TEST(InstrumentTable, SaysWhatIsAllowed)
{
    const auto error = [](const std::string& text) {
        return test::input_error_of([&] { (void)read_csv_spectra(text, "t.csv"); });
    };
    EXPECT_EQ(error("Energy (eV),R\n2,0.5\n3,0.25\n"),
              "t.csv:1: wavelength: the first column must be numbers, or be called wavelength_nm, "
              "wavelength_um, Wavelength (nm), λ (µm), WL … (got 'Energy (eV)')");
    EXPECT_EQ(error("nm,R\n400,1\n410,0,0,5\n"),
              "t.csv:3: must have 2 numbers as the rows before (got 4); where numbers have decimal "
              "commas, there must be ; or tabs between them");
    EXPECT_EQ(error("400;0.5\n410;0,5\n420;0,6\n"),
              "t.csv:2: column 2: must have a decimal point as the numbers before (got '0,5')");
    EXPECT_EQ(error("400\t1,000.5\n410\t1\n"),
              "t.csv:1: column 2: must be a finite number (got '1,000.5')");
    EXPECT_EQ(
        error("500;1\n400;2\n450;3\n"),
        "t.csv:3: wavelength: must be > 0 and descending as before (got 450 nm after 400 nm)");
    EXPECT_EQ(error("400;1\n500;2\n450;3\n"),
              "t.csv:3: wavelength: must be > 0 and ascending (got 450 nm after 500 nm)");
    EXPECT_EQ(error("wavelength;R\n0,4;1\n0,5;1\n"),
              "t.csv:1: wavelength: must reach 30 nm; for µm the column must be called "
              "wavelength_um (got 0.4 … 0.5)");
    // An empty name between quotes.
    EXPECT_EQ(error("nm \"\" (%)\n400\n"),
              "t.csv:2: must have 3 numbers as the rows before (got 1)");
    for (const char* name : {"length", "nm um", "thickness (nm)", "in", "wavenumber (1/cm)"})
        EXPECT_NE(error(std::string(name) + ";R\n400;1\n500;1\n").find("the first column must be"),
                  std::string::npos)
            << name;
}

TEST(InstrumentTable, MayBeOfOpticalConstants)
{
    std::vector<std::string> changes;
    const Medium medium = parse_refractiveindex_yaml(
        refractiveindex_yaml_from_csv(utf16(u"\u03BB (nm);N;K\r\n700;1,4;0,5\r\n400;1,5;0\r\n"),
                                      "m.csv", "", changes),
        "m");
    EXPECT_EQ(medium.constants->at(400), Complex(1.5, 0.0));
    EXPECT_EQ(medium.constants->at(700), Complex(1.4, 0.5));
    EXPECT_TRUE(changes.empty());
}

}  // namespace
}  // namespace nacre::spectral
