// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/working_range.h"
#include "nacre/capi/library.h"
#include "nacre/capi/stack_colour.h"
#include "refusal.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace {

using nacre::test::error;

constexpr const char* kEnds = "BaTiO3/Wemple-o";  // 400 … 700 nm
constexpr const char* kNote =
    "BaTiO3/Wemple-o: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous weight (D65, "
    "cie1931)";
constexpr const char* kStrict =
    "must be within the data, 400 … 700 nm (got 360); without --strict-range (strict_range= in "
    "Python) n and k are held at their ends";

const std::string kHead = R"(schema = 1
[material]
id = "t"
name = "T"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
)";
const std::string kFilm = kHead + R"([[layer]]
medium = "BaTiO3/Wemple-o"
thickness_nm = 300
[[layer]]
medium = "ZnTe/Sato"
thickness_nm = 100
[[layer]]
medium = "BaTiO3/Wemple-o"
thickness_nm = 300
[substrate]
medium = "Si/Green-2008"
)";

using Pairs = std::array<double, 2 * NACRE_WAVELENGTHS>;

TEST(CapiWorkingRange, HoldsEndsOrRefuses)
{
    Pairs n{};
    ASSERT_EQ(nacre_library_index_on_grid(kEnds, 0, n.data()), NACRE_OK);
    std::array<double, 2> at_400{};
    const double nm = 400.0;
    ASSERT_EQ(nacre_library_index(kEnds, 1, &nm, at_400.data()), NACRE_OK);
    EXPECT_EQ((std::array{n[0], n[1]}), at_400);
    EXPECT_EQ((std::array{n[80], n[81]}), at_400);
    EXPECT_NE(n[82], n[80]);

    const Pairs before = n;
    EXPECT_EQ(error(nacre_library_index_on_grid(kEnds, 1, n.data())),
              std::string("BaTiO3/Wemple-o: wavelength_nm: ") + kStrict);
    EXPECT_NE(error(nacre_library_index_on_grid("TiO2/Devore-o", 0, n.data()))
                  .find("what is needed is 400 … 700 nm"),
              std::string::npos);
    EXPECT_EQ(n, before);
    EXPECT_EQ(nacre_library_index_on_grid("no/such", 0, n.data()), NACRE_INPUT);
    EXPECT_EQ(nacre_library_index_on_grid("Ag/Johnson", 1, n.data()), NACRE_OK);
    // One wavelength outside stays an error.
    const double outside = 380.0;
    EXPECT_EQ(error(nacre_library_index(kEnds, 1, &outside, at_400.data())),
              "BaTiO3/Wemple-o: wavelength_nm: must be within the data, 400 … 700 nm (got 380)");
}

TEST(CapiWorkingRange, SaysWhatIsHeld)
{
    double percent = 7.0;
    const char* note = nullptr;
    ASSERT_EQ(nacre_library_held_ends(kEnds, "D65", "cie1931", 0, &percent, &note), NACRE_OK);
    EXPECT_NEAR(percent, 0.0402, 5e-5);
    EXPECT_STREQ(note, kNote);
    ASSERT_EQ(nacre_library_held_ends("Ag/Johnson", "D65", "cie1931", 1, &percent, &note),
              NACRE_OK);
    EXPECT_EQ(percent, 0.0);
    EXPECT_STREQ(note, "");
    ASSERT_EQ(nacre_library_held_ends("air", "A", "cie1964", 1, &percent, nullptr), NACRE_OK);
    EXPECT_EQ(error(nacre_library_held_ends(kEnds, "D65", "cie1931", 1, &percent, nullptr)),
              std::string("BaTiO3/Wemple-o: wavelength_nm: ") + kStrict);
}

TEST(CapiWorkingRange, SaysWhatATemplateHolds)
{
    const char* notes = nullptr;
    const auto held = [&](const std::string& text, int strict_range) {
        return nacre_template_held_ends(text.c_str(), "t.toml", "D65", "cie1931", strict_range,
                                        &notes);
    };
    ASSERT_EQ(held(kFilm, 0), NACRE_OK);
    EXPECT_EQ(std::string(notes).substr(0, std::string(kNote).size()), kNote);
    EXPECT_NE(std::string(notes).find("\nZnTe/Sato: n and k are held beyond 221.4 … 826.56 nm, "
                                      "< 0.001 %"),
              std::string::npos);
    EXPECT_EQ(std::string(notes).find("BaTiO3", 1), std::string::npos);
    const std::string message = error(held(kFilm, 1));
    EXPECT_EQ(message.find(std::string("t.toml:10: layer[0].medium: ") + kStrict), 0U) << message;
    EXPECT_NE(message.find("t.toml:16: layer[2].medium: "), std::string::npos) << message;
    ASSERT_EQ(held(kHead + "[substrate]\nmedium = \"Ag/Johnson\"\n", 1), NACRE_OK);
    EXPECT_STREQ(notes, "");
}

TEST(CapiWorkingRange, RefusesNull)
{
    Pairs n{};
    double percent = 0.0;
    EXPECT_EQ(error(nacre_library_index_on_grid(nullptr, 0, n.data())), "key: must not be null");
    EXPECT_EQ(error(nacre_library_index_on_grid("air", 0, nullptr)), "n: must not be null");
    EXPECT_EQ(error(nacre_library_held_ends("air", nullptr, "cie1931", 0, &percent, nullptr)),
              "illuminant: must not be null");
    EXPECT_EQ(error(nacre_library_held_ends("air", "D65", nullptr, 0, &percent, nullptr)),
              "observer: must not be null");
    EXPECT_EQ(error(nacre_library_held_ends("air", "D65", "cie1931", 0, nullptr, nullptr)),
              "percent: must not be null");
    EXPECT_EQ(error(nacre_template_held_ends("", "t", "D65", "cie1931", 0, nullptr)),
              "notes: must not be null");
}

}  // namespace
