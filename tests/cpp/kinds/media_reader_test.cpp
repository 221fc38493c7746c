// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/media_reader.h"

#include <gtest/gtest.h>

#include "support/expect.h"

namespace nacre::kinds {
namespace {

using material::MediumSpec;

MediumSpec constant(double n, double k)
{
    return {.value = material::ConstantMedium{n, k}, .line = 7, .field = "layer[0].n"};
}

TEST(MediaReader, LooksUpWhatIsNamedAndBuildsWhatIsDescribed)
{
    MediaReader media("t.toml", spectral::RangeRule::hold_ends);
    EXPECT_EQ(media.on_grid(constant(1.5, 0.25))[100], std::complex<double>(1.5, 0.25));
    const MediumSpec glass{
        .value = material::AbbeMedium{1.5168, 64.17}, .line = 1, .field = "glass"};
    EXPECT_NEAR(media.constants(glass)->at(kLineD).real(), 1.5168, 1e-6);
    const MediumSpec named{.value = material::LibraryMedium{"air"}, .line = 1, .field = "ambient"};
    EXPECT_NEAR(media.clear_on_grid(named, kTraceOfK)[0].real(), 1.0, 1e-3);
    EXPECT_NO_THROW(media.throw_if_any());
}

TEST(MediaReader, CollectsProblemsWithTheirLines)
{
    MediaReader media("t.toml", spectral::RangeRule::hold_ends);
    EXPECT_EQ(media.on_grid({.value = material::LibraryMedium{"none"}, .line = 3, .field = "a"})[0],
              1.0);
    static_cast<void>(media.clear_on_grid(constant(1.5, 0.5), kTraceOfK));
    const std::string text = test::input_error_of([&] { media.throw_if_any(); });
    EXPECT_EQ(text.find("t.toml:3: a: "), 0u);
    EXPECT_NE(
        text.find("t.toml:7: layer[0].n: must not absorb: k must be ≤ 0.0001 (got up to 0.5)"),
        std::string::npos);
}

}  // namespace
}  // namespace nacre::kinds
