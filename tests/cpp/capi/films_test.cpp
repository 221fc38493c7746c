// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/films.h"
#include "refusal.h"
#include "support/not_numbers.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace {

using nacre::test::kNan;

using nacre::test::error;

struct FilmCall {
    std::vector<double> n, d_nm{300.0};
    nacre_film film{};
    nacre_result* result = nullptr;

    FilmCall()
    {
        for (const double index : {1.0, 1.33, 1.5})
            for (int i = 0; i < NACRE_WAVELENGTHS; ++i) n.insert(n.end(), {index, 0.0});
        film = {.layers = 1,
                .n = n.data(),
                .d_nm = d_nm.data(),
                .coherent = nullptr,
                .varying = 0,
                .min = 100.0,
                .max = 300.0,
                .illuminant = "D65",
                .observer = "cie1931",
                .space = "lin_rec709_scene",
                .adaptation = nullptr,
                .tolerance = 0.5,
                .width = 9,
                .height = 5,
                .transmittance = 1,
                .single_precision = 0};
    }
    nacre_status operator()() { return nacre_film_lut(&film, &result); }
};

TEST(CapiFilm, MakesTables)
{
    FilmCall call;
    ASSERT_EQ(call(), NACRE_OK);
    ASSERT_EQ(nacre_result_tables(call.result), 2U);
    nacre_table R, T;
    ASSERT_EQ(nacre_result_table(call.result, 0, &R), NACRE_OK);
    ASSERT_EQ(nacre_result_table(call.result, 1, &T), NACRE_OK);
    EXPECT_STREQ(R.name, "R");
    EXPECT_STREQ(R.quantity, "reflectance");
    EXPECT_STREQ(T.name, "T");
    EXPECT_STREQ(R.x_name, "cos_theta");
    EXPECT_STREQ(R.y_name, "thickness_nm");
    EXPECT_EQ(R.x_min, 0.0);
    EXPECT_EQ(R.x_max, 1.0);
    EXPECT_EQ(R.y_min, 100.0);
    EXPECT_EQ(R.y_max, 300.0);
    EXPECT_EQ(R.width, 9);
    EXPECT_EQ(R.height, 5);
    EXPECT_EQ(R.channels, 3);
    EXPECT_GT(R.error_max, R.error_mean);
    for (int i = 0; i < 9 * 5 * 3; ++i)  // clear media: what is not reflected gets through
        EXPECT_NEAR(R.texels[i] + T.texels[i], 1.0F, 1e-6F);

    nacre_table untouched{};
    untouched.name = "before";
    EXPECT_EQ(error(nacre_result_table(call.result, 2, &untouched)), "index: must be < 2 (got 2)");
    EXPECT_STREQ(untouched.name, "before");
    EXPECT_EQ(error(nacre_result_table(call.result, 0, nullptr)), "table: must not be null");
    EXPECT_EQ(nacre_result_text(call.result, "osl"), nullptr);  // a film has no texts
    nacre_result_free(call.result);
}

TEST(CapiFilm, ToleranceDecidesTheSize)
{
    FilmCall call;
    call.film.width = call.film.height = 0;
    call.film.varying = -2;
    call.film.transmittance = 0;
    ASSERT_EQ(call(), NACRE_OK);
    ASSERT_EQ(nacre_result_tables(call.result), 1U);
    nacre_table table;
    ASSERT_EQ(nacre_result_table(call.result, 0, &table), NACRE_OK);
    EXPECT_EQ(table.height, 1);
    EXPECT_LE(table.error_max, 0.5);
    nacre_result_free(call.result);
}

TEST(CapiFilm, SinglePrecisionWhereErrorsAreNotMeasured)
{
    FilmCall call;
    call.film.single_precision = 1;
    EXPECT_EQ(error(call()),
              "single_precision: must be 0 where errors are measured: their truth is double");
    call.film.tolerance = 0.0;
    ASSERT_EQ(call(), NACRE_OK);
    nacre_table single, measured;
    ASSERT_EQ(nacre_result_table(call.result, 0, &single), NACRE_OK);
    FilmCall exact;
    ASSERT_EQ(exact(), NACRE_OK);
    ASSERT_EQ(nacre_result_table(exact.result, 0, &measured), NACRE_OK);
    for (int i = 0; i < 9 * 5 * 3; ++i) EXPECT_NEAR(single.texels[i], measured.texels[i], 1e-5F);
    nacre_result_free(exact.result);
    nacre_result_free(call.result);
}

TEST(CapiFilm, ScalesAllCoherentLayers)
{
    FilmCall call;
    call.film.varying = -1;
    call.film.min = 0.5;
    call.film.max = 2.0;
    ASSERT_EQ(call(), NACRE_OK);
    nacre_table table;
    ASSERT_EQ(nacre_result_table(call.result, 0, &table), NACRE_OK);
    EXPECT_STREQ(table.y_name, "thickness_scale");
    nacre_result_free(call.result);
}

TEST(CapiFilm, RefusesBadInputAndLeavesTheResultAlone)
{
    const auto with = [](auto&& change) {
        FilmCall call;
        change(call);
        const std::string message = error(call());
        EXPECT_EQ(call.result, nullptr);
        return message;
    };
    EXPECT_EQ(with([](FilmCall& c) { c.film.n = nullptr; }), "n: must not be null");
    EXPECT_EQ(with([](FilmCall& c) { c.film.d_nm = nullptr; }), "d_nm: must not be null");
    EXPECT_EQ(with([](FilmCall& c) { c.film.illuminant = nullptr; }),
              "illuminant: must not be null");
    EXPECT_EQ(with([](FilmCall& c) { c.film.observer = nullptr; }), "observer: must not be null");
    EXPECT_EQ(with([](FilmCall& c) { c.film.space = nullptr; }), "space: must not be null");
    EXPECT_EQ(with([](FilmCall& c) { c.film.layers = 65; }),
              "d_nm: must have at most 64 layers (got 65)");
    EXPECT_EQ(with([](FilmCall& c) { c.film.varying = -3; }),
              "varying: must be the index of a layer, -1 (scale) or -2 (nothing)");
    EXPECT_EQ(with([](FilmCall& c) { c.film.varying = 1; }),
              "variation: must name one of the 1 layers (got layer[1])");
    EXPECT_EQ(with([](FilmCall& c) { c.film.max = 50.0; }),
              "variation: must have 0 ≤ min < max, both finite (got 100 and 50)");
    EXPECT_EQ(with([](FilmCall& c) { c.d_nm[0] = -1.0; }),
              "d_nm[0]: must be finite and ≥ 0 (at 360 nm)");
    EXPECT_EQ(with([](FilmCall& c) { c.n[2 * NACRE_WAVELENGTHS + 3] = -1.0; }),
              "n[1]: imaginary part must be ≥ 0 (media with gain are not supported) (at 361 nm)");
    EXPECT_EQ(with([](FilmCall& c) { c.film.tolerance = kNan; }),
              "tolerance: must be > 0 (got nan)");
    EXPECT_EQ(with([](FilmCall& c) { c.film.width = 1; }),
              "size: must be 2…16384 texels wide and 2…16384 high (got 1x5)");
    EXPECT_NE(with([](FilmCall& c) { c.film.space = "X"; }).find("lin_ap1_scene"),
              std::string::npos);
    FilmCall call;
    EXPECT_EQ(error(nacre_film_lut(nullptr, &call.result)), "film: must not be null");
    EXPECT_EQ(error(nacre_film_lut(&call.film, nullptr)), "result: must not be null");
}

// Results are apart: freeing one leaves the texels of another.
TEST(CapiResult, ResultsLiveApart)
{
    FilmCall first, second;
    ASSERT_EQ(first(), NACRE_OK);
    ASSERT_EQ(second(), NACRE_OK);
    nacre_table kept;
    ASSERT_EQ(nacre_result_table(second.result, 0, &kept), NACRE_OK);
    const std::vector<float> before(kept.texels, kept.texels + 9 * 5 * 3);
    nacre_result_free(first.result);
    FilmCall failed;
    failed.film.min = -1.0;
    EXPECT_EQ(failed(), NACRE_INPUT);
    EXPECT_EQ(std::vector<float>(kept.texels, kept.texels + 9 * 5 * 3), before);
    nacre_result_free(second.result);
}

}  // namespace
