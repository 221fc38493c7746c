// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/working_range.h"

#include <cmath>

#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/spectral/colour.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

/// n = 1 + λ/1000 and k = λ/10000 from the one wavelength to the other.
Medium ramp(int first_nm, int last_nm)
{
    const auto row = [](int nm) {
        return std::to_string(nm / 1000.0) + " " + std::to_string(1.0 + nm / 1000.0) + " " +
               std::to_string(nm / 10000.0);
    };
    return parse_refractiveindex_yaml("DATA:\n  - type: tabulated nk\n    data: |\n        " +
                                          row(first_nm) + "\n        " + row(last_nm) + "\n",
                                      "ramp");
}

TEST(WorkingRange, HoldsBothEnds)
{
    const Medium medium = ramp(400, 700);
    const OpticalConstantsPtr held = WorkingRange(RangeRule::hold_ends).cover(medium.constants);
    for (const double nm : {360.0, 399.9, 400.0})
        EXPECT_COMPLEX_NEAR(held->at(nm), Complex(1.4, 0.04), 1e-15);
    for (const double nm : {700.0, 700.1, 830.0})
        EXPECT_COMPLEX_NEAR(held->at(nm), Complex(1.7, 0.07), 1e-15);
    EXPECT_COMPLEX_NEAR(held->at(550.0), medium.constants->at(550.0), 0.0);
    EXPECT_EQ(held->range_nm(), (std::array{360.0, 830.0}));
    EXPECT_COMPLEX_NEAR(held->on_grid().front(), Complex(1.4, 0.04), 1e-15);
    // Only colours are summed beyond the data.
    for (const double nm : {359.9, 830.1})
        EXPECT_INPUT_ERROR((void)held->at(nm), "must be within the data, 400 … 700 nm");
    EXPECT_INPUT_ERROR((void)medium.constants->at(380.0),
                       "must be within the data, 400 … 700 nm (got 380)");
}

TEST(WorkingRange, LeavesDataBeyondItAlone)
{
    const OpticalConstantsPtr held =
        WorkingRange(RangeRule::hold_ends).cover(ramp(300, 700).constants);
    EXPECT_EQ(held->range_nm(), (std::array{300.0, 830.0}));
    EXPECT_COMPLEX_NEAR(held->at(300.0), Complex(1.3, 0.03), 1e-15);
    EXPECT_COMPLEX_NEAR(held->at(830.0), Complex(1.7, 0.07), 1e-15);

    const Medium wide = ramp(360, 830);
    for (const RangeRule rule : {RangeRule::hold_ends, RangeRule::strict})
        EXPECT_EQ(WorkingRange(rule).cover(wide.constants), wide.constants);
}

TEST(WorkingRange, GivesTheSameObjectForTheSameMedium)
{
    WorkingRange range(RangeRule::hold_ends);
    const Medium one = ramp(400, 700), other = ramp(400, 700);
    EXPECT_EQ(range.cover(one.constants), range.cover(one.constants));
    EXPECT_NE(range.cover(one.constants), range.cover(other.constants));
}

TEST(WorkingRange, SaysWhatIsNeeded)
{
    const auto error = [](int first_nm, int last_nm, RangeRule rule) {
        return test::input_error_of(
            [&] { (void)WorkingRange(rule).cover(ramp(first_nm, last_nm).constants); });
    };
    const std::string needed =
        "what is needed is 400 … 700 nm, beyond which n and k may be held at their ends";
    for (const RangeRule rule : {RangeRule::hold_ends, RangeRule::strict}) {
        EXPECT_EQ(error(401, 900, rule),
                  "wavelength_nm: must be within the data, 401 … 900 nm (got 400); " + needed);
        EXPECT_EQ(error(300, 699, rule),
                  "wavelength_nm: must be within the data, 300 … 699 nm (got 700); " + needed);
    }
    const std::string held =
        "without --strict-range (strict_range= in Python) n and k are held at their ends";
    EXPECT_EQ(error(400, 900, RangeRule::strict),
              "wavelength_nm: must be within the data, 400 … 900 nm (got 360); " + held);
    EXPECT_EQ(error(300, 829, RangeRule::strict),
              "wavelength_nm: must be within the data, 300 … 829 nm (got 830); " + held);
}

TEST(HeldEnds, StateTheirShareOfTheLuminousWeight)
{
    const Illuminant equal = named_illuminant("E");
    const auto share = [&](int first_nm, int last_nm) {
        return held_ends(ramp(first_nm, last_nm), equal, ObserverId::cie1931).value().percent;
    };
    const Observer& eye = observer(ObserverId::cie1931);
    EXPECT_NEAR(share(361, 830), 100.0 * eye.y.front() / eye.sum_y, 1e-12);
    EXPECT_NEAR(share(360, 829), 100.0 * eye.y.back() / eye.sum_y, 1e-12);
    EXPECT_NEAR(share(400, 700), share(400, 830) + share(360, 700), 1e-12);
    // Light of one line beyond the data is held altogether.
    EXPECT_NEAR(held_ends(ramp(400, 700), named_illuminant("line:380"), ObserverId::cie1931)
                    .value()
                    .percent,
                100.0, 1e-12);
}

TEST(HeldEnds, ReadAsANote)
{
    const auto note = [](const char* illuminant, ObserverId observer) {
        return held_ends(ramp(400, 700), named_illuminant(illuminant), observer).value().note();
    };
    EXPECT_EQ(note("D65", ObserverId::cie1931),
              "ramp: n and k are held beyond 400 … 700 nm, 0.0402 % of the luminous weight (D65, "
              "cie1931)");
    EXPECT_EQ(note("line:589.3", ObserverId::cie1964),
              "ramp: n and k are held beyond 400 … 700 nm, < 0.001 % of the luminous "
              "weight (line:589.3, cie1964)");
}

TEST(HeldEnds, AreNoneWhereNothingIsHeld)
{
    const Illuminant light = named_illuminant("D65");
    EXPECT_FALSE(held_ends(ramp(360, 830), light, ObserverId::cie1931));
    EXPECT_FALSE(held_ends(ramp(401, 830), light, ObserverId::cie1931));  // refused
    EXPECT_FALSE(held_ends(library_medium("air"), light, ObserverId::cie1931));
}

}  // namespace
}  // namespace nacre::spectral
