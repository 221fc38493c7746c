// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/templates.h"
#include "refusal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using nacre::test::error;

const char* const kTemplate = R"(schema = 1
[material]
id = "test_film"
name = "Test Film"
category = "Tests"
source = "made up"
[ambient]
medium = "air"
[[layer]]
n = 1.33
thickness_nm = { default = 200, min = 100, max = 300, varies = true }
[substrate]
n = 1.5
)";

TEST(CapiTemplates, NewTexelsForAnEditedFilm)
{
    const auto preview = [](const char* text, const nacre_table_size* sizes, size_t count,
                            nacre_result** result) {
        return nacre_preview_template(text, "film.toml", "D65", "cie1931", "lin_rec709_scene",
                                      nullptr, count, sizes, result);
    };
    const nacre_table_size sizes[] = {{"R", 40, 60}, {"R_schlick", 6, 20}, {"R_rough", 200, 20}};
    nacre_result* result = nullptr;
    ASSERT_EQ(preview(kTemplate, sizes, 3, &result), NACRE_OK) << nacre_last_error();
    ASSERT_EQ(nacre_result_tables(result), 2U);
    nacre_table table;
    ASSERT_EQ(nacre_result_table(result, 1, &table), NACRE_OK);
    EXPECT_STREQ(table.name, "R_rough");
    EXPECT_EQ(table.width, 200);
    EXPECT_EQ(nacre_result_text(result, "osl"), nullptr);
    nacre_result_free(result);
    result = nullptr;

    const nacre_table_size none{"T", 40, 60};
    EXPECT_EQ(error(preview(kTemplate, &none, 1, &result)),
              "film.toml: such a film has no table T; compile it anew");
    EXPECT_EQ(error(preview(kTemplate, nullptr, 1, &result)), "sizes: must not be null");
    EXPECT_EQ(result, nullptr);
}

TEST(CapiTemplates, SpectrumOfATemplate)
{
    std::vector<double> R(NACRE_WAVELENGTHS), T(NACRE_WAVELENGTHS), colours(6);
    const auto spectrum = [&](double value, double angle_deg, const char* adaptation = nullptr,
                              const char* light = "D65") {
        return nacre_template_spectrum(kTemplate, "film.toml", light, "cie1931", "lin_rec709_scene",
                                       adaptation, value, angle_deg, R.data(), T.data(),
                                       colours.data());
    };
    ASSERT_EQ(spectrum(200.0, 30.0), NACRE_OK) << nacre_last_error();
    for (std::size_t i = 0; i < R.size(); ++i) EXPECT_NEAR(R[i] + T[i], 1.0, 1e-12);
    EXPECT_GT(colours[0], 0.0);
    EXPECT_EQ(error(spectrum(200.0, 90.0)), "angle_deg: must be in [0, 90) (got 90)");
    EXPECT_EQ(error(spectrum(-1.0, 0.0)), "value: must be ≥ 0 and finite (got -1)");

    // A clear film under a lamp: its colours have that of the lamp in them, or have not.
    ASSERT_EQ(spectrum(200.0, 30.0, nullptr, "A"), NACRE_OK);
    EXPECT_NEAR(colours[0] + colours[3], 1.0, 1e-6);
    EXPECT_NEAR(colours[2] + colours[5], 1.0, 1e-6);
    ASSERT_EQ(spectrum(200.0, 30.0, "none", "A"), NACRE_OK);
    EXPECT_GT(colours[0] + colours[3], 1.5);
    EXPECT_LT(colours[2] + colours[5], 0.4);
    EXPECT_NE(error(spectrum(200.0, 30.0, "von_kries")).find("adaptation"), std::string::npos);
}

}  // namespace
