// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "nacre/capi/library.h"
#include "refusal.h"

namespace {

using nacre::test::error;

nacre_shape shape(nacre_shape_kind kind, const std::array<double, 4>& numbers)
{
    nacre_shape result{};
    result.kind = kind;
    for (std::size_t i = 0; i < 4; ++i) result.numbers[i] = numbers[i];
    return result;
}

constexpr std::array<double, 5> kNm = {450, 500, 550, 600, 650};

TEST(CapiShapes, AddUpAtAnyWavelengths)
{
    const double points_nm[] = {500, 600}, points[] = {1, 3};
    std::array<nacre_shape, 4> shapes = {
        shape(NACRE_CONSTANT, {0.5}), shape(NACRE_BOX, {480, 520, 2, 0}),
        shape(NACRE_GAUSSIAN, {600, 100, 4}), shape(NACRE_LINEAR, {})};
    shapes[3].count = 2;
    shapes[3].wavelength_nm = points_nm;
    shapes[3].values = points;
    std::array<double, 5> sum{};
    ASSERT_EQ(nacre_sum_of_shapes(4, shapes.data(), nullptr, 5, kNm.data(), sum.data()), NACRE_OK);
    // A Gaussian is half its peak at half its width, and 1/16 of it at its width.
    const std::array<double, 5> wanted = {0.5 + 4.0 / 512 + 1, 0.5 + 2 + 4.0 / 16 + 1, 0.5 + 2 + 2,
                                          0.5 + 4 + 3, 0.5 + 2 + 3};
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(sum[i], wanted[i], 1e-12) << kNm[i];
    shapes[3].kind = NACRE_SMOOTH;
    ASSERT_EQ(nacre_sum_of_shapes(1, &shapes[3], nullptr, 5, kNm.data(), sum.data()), NACRE_OK);
    EXPECT_EQ(sum, (std::array<double, 5>{1, 1, 2, 3, 3}));
}

TEST(CapiShapes, TakeOtherSpectraTimesAFactor)
{
    nacre_shape half = shape(NACRE_SCALED, {0.5});
    half.key = "cie/D65";
    const double both[] = {560, 561};
    double values[2];
    ASSERT_EQ(nacre_sum_of_shapes(1, &half, nullptr, 2, both, values), NACRE_OK);
    EXPECT_EQ(values[0], 50.0);

    // Six samples in equal steps: a reflectance goes along a curve, an emission straight.
    const double samples_nm[] = {500, 520, 540, 560, 580, 600}, samples[] = {0, 0, 1, 1, 0, 0};
    half.key = nullptr;
    half.count = 6;
    half.wavelength_nm = samples_nm;
    half.values = samples;
    const double between[] = {550, 570};
    half.of_kind = "emission";
    ASSERT_EQ(nacre_sum_of_shapes(1, &half, nullptr, 2, between, values), NACRE_OK);
    EXPECT_EQ(values[0], 0.5);
    half.of_kind = "reflectance";
    ASSERT_EQ(nacre_sum_of_shapes(1, &half, nullptr, 2, between, values), NACRE_OK);
    EXPECT_GT(values[0], 0.55);
    half.of_kind = "paint";
    EXPECT_NE(
        error(nacre_sum_of_shapes(1, &half, nullptr, 2, between, values)).find("got \"paint\""),
        std::string::npos);
}

TEST(CapiShapes, NameWhatIsWrong)
{
    std::array<double, 5> sum{};
    const auto message = [&sum](const nacre_shape& given) {
        return error(nacre_sum_of_shapes(1, &given, nullptr, 5, kNm.data(), sum.data()));
    };
    EXPECT_NE(message(shape(NACRE_GAUSSIAN, {555, 10, 1})).find("must be ≥ 50 nm"),
              std::string::npos);
    EXPECT_NE(message(shape(NACRE_BOX, {560, 590, 1, 0})).find("550 and 600 nm"),
              std::string::npos);
    EXPECT_EQ(message(shape(NACRE_LINEAR, {})), "wavelength_nm: must not be null (item 0)");
    const nacre_shape dark = shape(NACRE_CONSTANT, {0});
    EXPECT_NE(error(nacre_sum_of_shapes(1, &dark, "emission", 5, kNm.data(), sum.data()))
                  .find("shapes: the sum does not suit: an emission must be"),
              std::string::npos);
    EXPECT_EQ(nacre_sum_of_shapes(1, &dark, "reflectance", 5, kNm.data(), sum.data()), NACRE_OK);
    EXPECT_EQ(error(nacre_sum_of_shapes(1, nullptr, nullptr, 5, kNm.data(), sum.data())),
              "shape: must not be null");
    const nacre_shape none{};
    EXPECT_EQ(error(nacre_sum_of_shapes(0, &none, nullptr, 5, kNm.data(), sum.data())),
              "shapes: must be at least one");
    EXPECT_EQ(sum, (std::array<double, 5>{}));
}

}  // namespace
