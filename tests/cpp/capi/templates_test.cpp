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

nacre_status compile(const char* text, nacre_result** result)
{
    return nacre_compile_template(text, "film.toml", "D65", "cie1931", "lin_rec709_scene", nullptr,
                                  1.0, result);
}

TEST(CapiCompile, MakesTextsAndTables)
{
    nacre_result* result = nullptr;
    ASSERT_EQ(compile(kTemplate, &result), NACRE_OK) << nacre_last_error();
    EXPECT_STREQ(nacre_result_text(result, "id"), "test_film");
    EXPECT_NE(std::string(nacre_result_text(result, "osl")).find("shader"), std::string::npos);
    EXPECT_NE(std::string(nacre_result_text(result, "manifest")).find("\"test_film\""),
              std::string::npos);
    EXPECT_EQ(nacre_result_text(result, "colour"), nullptr);
    EXPECT_EQ(nacre_result_text(result, nullptr), nullptr);
    EXPECT_EQ(nacre_result_text(nullptr, "id"), nullptr);
    ASSERT_GE(nacre_result_tables(result), 1U);
    nacre_table table;
    ASSERT_EQ(nacre_result_table(result, 0, &table), NACRE_OK);
    EXPECT_LE(table.error_max, 1.0);
    nacre_result_free(result);
}

TEST(CapiCompile, NamesFileLineAndField)
{
    nacre_result* result = nullptr;
    std::string text = kTemplate;
    text.replace(text.find("min = 100"), 9, "min = -10");
    const std::string message = error(compile(text.c_str(), &result));
    EXPECT_TRUE(message.starts_with("film.toml:11: ")) << message;
    EXPECT_EQ(result, nullptr);
    EXPECT_TRUE(error(compile("schema = [", &result)).starts_with("film.toml:1: "));

    text = kTemplate;
    text.replace(text.find("\"air\""), 5, "\"unobtainium/X\"");
    EXPECT_NE(error(compile(text.c_str(), &result)).find("unobtainium/X"), std::string::npos);
}

TEST(CapiCompile, RefusesNull)
{
    nacre_result* result = nullptr;
    EXPECT_EQ(error(compile(nullptr, &result)), "text: must not be null");
    EXPECT_EQ(error(compile(kTemplate, nullptr)), "result: must not be null");
    const auto call = [&](const char* file, const char* illuminant, const char* observer,
                          const char* space) {
        return error(nacre_compile_template(kTemplate, file, illuminant, observer, space, nullptr,
                                            1.0, &result));
    };
    EXPECT_EQ(call(nullptr, "D65", "cie1931", "xyz_d65"), "file: must not be null");
    EXPECT_EQ(call("f", nullptr, "cie1931", "xyz_d65"), "illuminant: must not be null");
    EXPECT_EQ(call("f", "D65", nullptr, "xyz_d65"), "observer: must not be null");
    EXPECT_EQ(call("f", "D65", "cie1931", nullptr), "space: must not be null");
}

}  // namespace
