// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi.h"
#include "refusal.h"
#include "support/not_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace {

using nacre::test::kNan;

using nacre::test::error;

bool starts_with(const std::string& text, const std::string& head)
{
    return text.rfind(head, 0) == 0;
}

TEST(Capi, VersionsAreThoseOfTheHeader)
{
    EXPECT_EQ(nacre_api_version(), NACRE_API_VERSION);
    EXPECT_STREQ(nacre_version(), NACRE_EXPECTED_VERSION);
}

// ---- Colour ------------------------------------------------------------------------------------

struct Spectrum {
    std::vector<double> wavelength{360.0, 830.0}, values{1.0, 1.0};
    int reflectance = 1;
    const char *illuminant = "D65", *observer = "cie1931", *space = "lin_rec709_scene";
    nacre_colour colour{{-7.0}, {-7.0}, {-7.0}};

    nacre_status operator()()
    {
        return nacre_spectrum_to_colour(values.size(), wavelength.data(), values.data(),
                                        reflectance, illuminant, observer, space, &colour);
    }
};

TEST(CapiColour, PerfectWhiteIsOne)
{
    for (const char* illuminant : {"D65", "A", "E", "D50"}) {
        for (const char* space : {"lin_rec709_scene", "lin_rec2020_scene", "lin_ap1_scene"}) {
            Spectrum white;
            white.illuminant = illuminant;
            white.space = space;
            ASSERT_EQ(white(), NACRE_OK);
            for (const double channel : white.colour.rgb) EXPECT_NEAR(channel, 1.0, 1e-12);
            EXPECT_NEAR(white.colour.XYZ[1], 1.0, 1e-14);
            EXPECT_NEAR(white.colour.Lab[0], 100.0, 1e-11);
            EXPECT_NEAR(white.colour.Lab[1], 0.0, 1e-10);
        }
    }
}

TEST(CapiColour, EmissionNeedsNoIlluminant)
{
    Spectrum equal_energy;
    equal_energy.reflectance = 0;
    equal_energy.illuminant = nullptr;
    ASSERT_EQ(equal_energy(), NACRE_OK);
    for (const double value : equal_energy.colour.XYZ) EXPECT_NEAR(value, 1.0, 1e-3);
}

TEST(CapiColour, RefusesUnknownNamesAndBadSamples)
{
    const auto with = [](auto&& change) {
        Spectrum spectrum;
        change(spectrum);
        const std::string message = error(spectrum());
        EXPECT_EQ(spectrum.colour.XYZ[0], -7.0) << message;
        return message;
    };
    EXPECT_NE(with([](Spectrum& s) { s.illuminant = "X"; }).find("D65"), std::string::npos);
    EXPECT_NE(with([](Spectrum& s) { s.observer = "X"; }).find("cie1964"), std::string::npos);
    EXPECT_NE(with([](Spectrum& s) { s.space = "X"; }).find("lin_ap1_scene"), std::string::npos);
    EXPECT_TRUE(starts_with(with([](Spectrum& s) {
                                s.wavelength = {500.0, 400.0};
                            }),
                            "wavelength_nm"));
    EXPECT_NE(with([](Spectrum& s) { s.values[1] = kNan; }), "");
    EXPECT_NE(with([](Spectrum& s) { s.values.clear(); }), "");
    EXPECT_NE(with([](Spectrum& s) { s.wavelength = {100.0, 200.0}; }), "");  // off the grid
    EXPECT_EQ(with([](Spectrum& s) { s.illuminant = nullptr; }), "illuminant: must not be null");
    EXPECT_EQ(with([](Spectrum& s) { s.observer = nullptr; }), "observer: must not be null");
    EXPECT_EQ(with([](Spectrum& s) { s.space = nullptr; }), "space: must not be null");
}

TEST(CapiColour, RefusesNullArrays)
{
    const double value = 1.0;
    nacre_colour colour;
    const auto call = [](const double* nm, const double* values, nacre_colour* out) {
        return error(nacre_spectrum_to_colour(1, nm, values, 0, nullptr, "cie1931",
                                              "lin_rec709_scene", out));
    };
    EXPECT_EQ(call(&value, &value, nullptr), "colour: must not be null");
    EXPECT_EQ(call(nullptr, &value, &colour), "wavelength_nm: must not be null");
    EXPECT_EQ(call(&value, nullptr, &colour), "values: must not be null");
}

// ---- Gratings ----------------------------------------------------------------------------------

nacre_grating disc()
{
    return {.pitch_nm = 1600.0,
            .wavelength_nm = 550.0,
            .grating_vector = {1.0, 0.0, 0.0},
            .normal = {0.0, 0.0, 1.0},
            .k_in = {0.0, 0.0, -1.0},
            .profile = "rectangular",
            .phase_rad = M_PI,
            .duty = 0.5};
}

TEST(CapiGrating, OrdersOfADisc)
{
    const nacre_grating grating = disc();
    double directions[9][3], efficiencies[9];
    ASSERT_EQ(nacre_grating_orders(&grating, -4, 4, directions[0], efficiencies), NACRE_OK);
    for (int i = 0; i < 9; ++i) {
        const double across = (i - 4) * 550.0 / 1600.0;
        const bool propagates = std::abs(across) < 1.0;
        EXPECT_NEAR(directions[i][0], propagates ? across : 0.0, 1e-15);
        EXPECT_NEAR(directions[i][2], propagates ? std::sqrt(1 - across * across) : 0.0, 1e-15);
    }
    EXPECT_NEAR(efficiencies[3], efficiencies[5], 1e-15);
    EXPECT_GT(efficiencies[5], 0.4);
    EXPECT_EQ(efficiencies[8], 0.0);
    EXPECT_EQ(directions[8][2], 0.0);
}

TEST(CapiGrating, RefusesBadInputAndLeavesTheOutputsAlone)
{
    double directions[9] = {-7.0}, efficiencies[3] = {-7.0};
    const auto with = [&](auto&& change) {
        nacre_grating grating = disc();
        change(grating);
        const std::string message =
            error(nacre_grating_orders(&grating, -1, 1, directions, efficiencies));
        EXPECT_EQ(directions[0], -7.0);
        EXPECT_EQ(efficiencies[0], -7.0);
        return message;
    };
    EXPECT_EQ(with([](nacre_grating& g) { g.pitch_nm = -1.0; }),
              "pitch_nm: must be finite and > 0");
    EXPECT_EQ(with([](nacre_grating& g) { g.wavelength_nm = kNan; }),
              "wavelength_nm: must be finite and > 0");
    EXPECT_EQ(with([](nacre_grating& g) { g.k_in[2] = 1.0; }),
              "k_in: must point towards the surface (k_in · normal < 0)");
    EXPECT_EQ(with([](nacre_grating& g) { g.profile = "square"; }),
              "profile.kind: must be sinusoidal, rectangular or blazed (got square)");
    EXPECT_EQ(with([](nacre_grating& g) { g.profile = nullptr; }),
              "profile.kind: must not be null");
    EXPECT_EQ(with([](nacre_grating& g) { g.duty = 2.0; }), "profile.duty: must be in [0, 1]");

    const nacre_grating grating = disc();
    EXPECT_EQ(error(nacre_grating_orders(nullptr, 0, 0, directions, efficiencies)),
              "grating: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 0, 0, nullptr, efficiencies)),
              "directions: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 0, 0, directions, nullptr)),
              "efficiencies: must not be null");
    EXPECT_EQ(error(nacre_grating_orders(&grating, 1, 0, directions, efficiencies)),
              "orders: must ascend and stay within ±100000");
}

// ---- Templates ---------------------------------------------------------------------------------

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
    EXPECT_TRUE(starts_with(message, "film.toml:11: ")) << message;
    EXPECT_EQ(result, nullptr);
    EXPECT_TRUE(starts_with(error(compile("schema = [", &result)), "film.toml:1: "));

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

TEST(CapiResult, NothingHoldsNothing)
{
    EXPECT_EQ(nacre_result_tables(nullptr), 0U);
    nacre_table table;
    EXPECT_EQ(error(nacre_result_table(nullptr, 0, &table)), "result: must not be null");
    nacre_result_free(nullptr);
}

// ---- Library -----------------------------------------------------------------------------------

TEST(CapiLibrary, KeysAscendAndOpenMedia)
{
    const std::size_t count = nacre_library_count();
    ASSERT_GT(count, 40U);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string key = nacre_library_key(i);
        if (i > 0) {
            EXPECT_LT(nacre_library_key(i - 1), key);
        }
        nacre_medium medium;
        ASSERT_EQ(nacre_library_medium(key.c_str(), &medium), NACRE_OK) << key;
        EXPECT_EQ(medium.key, key);
        EXPECT_STRNE(medium.name, "");
        EXPECT_STRNE(medium.references, "");
        EXPECT_LT(medium.first_nm, medium.last_nm);
    }
    EXPECT_EQ(nacre_library_key(count), nullptr);
    EXPECT_EQ(nacre_library_key(std::numeric_limits<std::size_t>::max()), nullptr);
}

TEST(CapiLibrary, IndexOfGlassAtTheSodiumLine)
{
    const double nm[] = {587.5618, 400.0};
    double n[4];
    ASSERT_EQ(nacre_library_index("N-BK7/SCHOTT", 2, nm, n), NACRE_OK);
    EXPECT_NEAR(n[0], 1.5168, 5e-6);  // n_d of the SCHOTT data sheet
    EXPECT_GT(n[2], n[0]);
    EXPECT_EQ(nacre_library_index("N-BK7/SCHOTT", 0, nullptr, nullptr), NACRE_OK);
}

TEST(CapiLibrary, RefusesUnknownMediaAndWavelengthsOutsideTheData)
{
    nacre_medium medium{};
    medium.key = "before";
    EXPECT_NE(error(nacre_library_medium("water/Daimon", &medium)).find("water/Daimon-20C"),
              std::string::npos);  // names near ones
    EXPECT_STREQ(medium.key, "before");
    EXPECT_EQ(error(nacre_library_medium(nullptr, &medium)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_medium("Au/Johnson", nullptr)), "medium: must not be null");

    const double nm[] = {550.0, 100.0};
    double n[4] = {-7.0, -7.0, -7.0, -7.0};
    const std::string outside = error(nacre_library_index("Au/Johnson", 2, nm, n));
    EXPECT_NE(outside.find("Au/Johnson"), std::string::npos) << outside;
    EXPECT_NE(outside.find("100"), std::string::npos) << outside;
    EXPECT_EQ(n[0], -7.0);
    EXPECT_EQ(error(nacre_library_index(nullptr, 1, nm, n)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_index("Au/Johnson", 1, nullptr, n)),
              "wavelength_nm: must not be null");
    EXPECT_EQ(error(nacre_library_index("Au/Johnson", 1, nm, nullptr)), "n: must not be null");
}

TEST(CapiLibrary, SpectraComeWithTheirSamples)
{
    const std::size_t count = nacre_library_spectrum_count();
    ASSERT_GT(count, 160U);
    EXPECT_EQ(nacre_library_spectrum_key(count), nullptr);
    for (std::size_t i = 0; i < count; ++i) {
        nacre_spectrum spectrum;
        ASSERT_EQ(nacre_library_spectrum(nacre_library_spectrum_key(i), &spectrum), NACRE_OK);
        EXPECT_STREQ(spectrum.key, nacre_library_spectrum_key(i));
        EXPECT_STRNE(spectrum.references, "") << spectrum.key;
        EXPECT_STRNE(spectrum.licence, "") << spectrum.key;
        ASSERT_GE(spectrum.count, 2U);
        EXPECT_LT(spectrum.wavelength_nm[0], spectrum.wavelength_nm[spectrum.count - 1]);
    }
    nacre_spectrum box{};
    ASSERT_EQ(nacre_library_spectrum("study/box", &box), NACRE_OK);
    EXPECT_STREQ(box.kind, "emission");
    EXPECT_EQ(box.count, 471U);
    EXPECT_EQ(box.values[0], 0.0);
    EXPECT_EQ(box.values[100], 1.0);

    EXPECT_NE(error(nacre_library_spectrum("study/bx", &box)).find("study/box"), std::string::npos);
    EXPECT_STREQ(box.key, "study/box");
    EXPECT_EQ(error(nacre_library_spectrum(nullptr, &box)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_spectrum("study/box", nullptr)), "spectrum: must not be null");
}

TEST(CapiLibrary, MayBeReadByThreads)
{
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([] {
            for (std::size_t j = 0; j < nacre_library_count(); ++j) {
                nacre_medium medium;
                EXPECT_EQ(nacre_library_medium(nacre_library_key(j), &medium), NACRE_OK);
            }
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
