// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/film_request.h"

#include <gtest/gtest.h>

namespace nacre::lut {
namespace {

TEST(FilmTableRequest, AsksForAnExactReflectanceUnlessItSaysOtherwise)
{
    const FilmTableRequest request{};
    EXPECT_EQ(request.tolerance, 0.1);
    EXPECT_TRUE(request.measure_error);
    EXPECT_FALSE(request.accept_error);
    EXPECT_FALSE(request.transmittance);
    EXPECT_EQ(request.texel_bits, kFloatBits);
    EXPECT_EQ(request.precision, Precision::double_precision);
    EXPECT_FALSE(request.technique);
}

}  // namespace
}  // namespace nacre::lut
