// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/stack_colour.h"
#include "refusal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using nacre::test::error;

constexpr nacre_colour_options kOptions{.illuminant = "D65",
                                        .observer = "cie1931",
                                        .space = "lin_rec709_scene",
                                        .adaptation = nullptr,
                                        .gamut = nullptr,
                                        .reflectance = 0};
constexpr double kAir[] = {1.0, 0.0};

/// Three soap films.
struct Films {
    std::vector<nacre_medium_index> media{
        {nullptr, kAir, 1}, {"water/Daimon-20C", nullptr, 0}, {"air", nullptr, 0}};
    std::vector<double> d_nm{90.0, 400.0, 1500.0}, angle_deg{0.0, 30.0, 80.0};

    [[nodiscard]] nacre_colour_stacks stacks(const char* sampling = nullptr) const
    {
        return {.layers = 1,
                .media = media.data(),
                .coherent = nullptr,
                .count = 3,
                .d_nm = d_nm.data(),
                .angle_deg = angle_deg.data(),
                .polarisation = NACRE_UNPOLARISED,
                .sampling = sampling};
    }
};

TEST(CapiStackColour, AFewWavelengthsAreAsGoodAsAll)
{
    const Films films;
    std::vector<nacre_colour> few(3), through(3), all(3);
    std::vector<std::size_t> wavelengths(3);
    const nacre_colour_stacks adaptive = films.stacks(), full = films.stacks("full");
    ASSERT_EQ(
        nacre_stack_colours(&adaptive, &kOptions, few.data(), through.data(), wavelengths.data()),
        NACRE_OK);
    ASSERT_EQ(nacre_stack_colours(&full, &kOptions, all.data(), nullptr, nullptr), NACRE_OK);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(wavelengths[i], 16u);
        EXPECT_NEAR(few[i].XYZ[1] + through[i].XYZ[1], 1.0, 1e-4);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(few[i].rgb[c], all[i].rgb[c], 1e-3);
    }
    EXPECT_GT(all[1].rgb[0], 2.0 * all[1].rgb[1]);  // magenta
}

TEST(CapiStackColour, IndicesAtEveryNanometre)
{
    std::vector<double> n;
    for (int nm = 360; nm <= 830; ++nm) n.insert(n.end(), {1.3 + 4e3 / (nm * nm), 0.0});
    Films films;
    films.media[1] = {nullptr, n.data(), NACRE_WAVELENGTHS};
    const nacre_colour_stacks stacks = films.stacks();
    std::vector<nacre_colour> colours(3);
    ASSERT_EQ(nacre_stack_colours(&stacks, &kOptions, colours.data(), nullptr, nullptr), NACRE_OK);
    EXPECT_GT(colours[1].rgb[0], colours[1].rgb[1]);

    n[200] = -1.0;
    EXPECT_EQ(error(nacre_stack_colours(&stacks, &kOptions, colours.data(), nullptr, nullptr)),
              "media[1].n at 460 nm: must be finite and > 0 (got -1)");
}

TEST(CapiStackColour, SaysWhatIsWrong)
{
    std::vector<nacre_colour> colours(3);
    const auto message = [&](auto&& change) {
        Films films;
        nacre_colour_stacks stacks = films.stacks();
        change(films, stacks);
        return error(nacre_stack_colours(&stacks, &kOptions, colours.data(), nullptr, nullptr));
    };
    EXPECT_EQ(message([](Films& films, auto&) { films.angle_deg[2] = 90.0; }),
              "angle_deg: must be in [0, 90) (got 90) (item 2)");
    EXPECT_EQ(message([](Films& films, auto&) { films.d_nm[1] = -1.0; }),
              "d_nm[0]: must be finite and ≥ 0 (got -1) (item 1)");
    EXPECT_EQ(message([](Films& films, auto&) { films.media[1].key = "wotter"; }).substr(0, 10),
              "media[1]: ");
    EXPECT_EQ(message([](Films&, auto& stacks) { stacks.media = nullptr; }),
              "media: must not be null");
    EXPECT_EQ(message([](Films&, auto& stacks) { stacks.sampling = "steps:x"; }).substr(0, 10),
              "sampling: ");
    EXPECT_EQ(error(nacre_stack_colours(nullptr, &kOptions, nullptr, nullptr, nullptr)),
              "stacks: must not be null");
}

TEST(CapiStackColour, RangeOfAllTogether)
{
    std::vector<double> rgb{-0.5, 1.0, 2.0, 4.0, 0.0, 0.2}, clamped = rgb;
    ASSERT_EQ(nacre_map_range(2, rgb.data(), "normalise"), NACRE_OK);
    EXPECT_EQ(rgb, (std::vector<double>{-0.125, 0.25, 0.5, 1.0, 0.0, 0.05}));
    ASSERT_EQ(nacre_map_range(2, clamped.data(), "clamp"), NACRE_OK);
    EXPECT_EQ(clamped, (std::vector<double>{0.0, 1.0, 1.0, 1.0, 0.0, 0.2}));
    EXPECT_EQ(error(nacre_map_range(2, rgb.data(), "loud")),
              "range: must be one of none, clamp, normalise (got 'loud')");
}

}  // namespace
