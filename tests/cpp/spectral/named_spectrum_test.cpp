// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/named_spectrum.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

TEST(NamedSpectrum, GoesToTheGridAsItsKindIsRead)
{
    const Spectrum bump({500, 510, 520, 530, 540, 550}, {0, 0, 1, 1, 0, 0});
    NamedSpectrum named{.key = {},
                        .name = {},
                        .references = {},
                        .licence = {},
                        .comments = {},
                        .tags = {},
                        .kind = SpectrumKind::emission,
                        .samples = bump};
    EXPECT_EQ(named.on_grid(), bump.on_grid(Interpolation::linear));
    named.kind = SpectrumKind::reflectance;
    EXPECT_EQ(named.on_grid(), bump.on_grid(Interpolation::sprague));
    EXPECT_NE(bump.on_grid(Interpolation::linear), bump.on_grid(Interpolation::sprague));
}

TEST(KindProblem, IsThatOfTheValues)
{
    const auto problem = [](std::vector<double> values, SpectrumKind kind) {
        return kind_problem(Spectrum({400.0, 700.0}, std::move(values)), kind).value_or("");
    };
    EXPECT_EQ(problem({0.0, 1.4}, SpectrumKind::reflectance), "");  // fluorescence
    EXPECT_EQ(problem({1.2, 1.4}, SpectrumKind::reflectance),
              "a reflectance must be ≤ 1 somewhere, 1 for all of the light (got 1.2 … 1.4)");
    EXPECT_EQ(problem({0.0, 100.0}, SpectrumKind::reflectance),
              "a reflectance must be in [0, 2], 1 for all of the light (got 0 … 100)");
    EXPECT_EQ(problem({0.0, 100.0}, SpectrumKind::emission), "");
    EXPECT_EQ(problem({0.0, 0.0}, SpectrumKind::emission), "an emission must be > 0 somewhere");
    EXPECT_EQ(spectrum_kind_name(SpectrumKind::emission), "emission");
}

}  // namespace
}  // namespace nacre::spectral
