// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi.h"

#include <gtest/gtest.h>

namespace {

// One name of each header.
TEST(Capi, IsAllOfTheInterface)
{
    EXPECT_NE(&nacre_last_error, nullptr);
    EXPECT_NE(&nacre_rgb_to_spectrum, nullptr);
    EXPECT_NE(&nacre_film_lut, nullptr);
    EXPECT_NE(&nacre_grating_orders, nullptr);
    EXPECT_NE(&nacre_library_medium, nullptr);
    EXPECT_NE(&nacre_sum_of_shapes, nullptr);
    EXPECT_NE(&nacre_read_spectra, nullptr);
    EXPECT_NE(&nacre_stack_colours, nullptr);
    EXPECT_NE(&nacre_stack_grid, nullptr);
    EXPECT_NE(&nacre_result_free, nullptr);
    EXPECT_NE(&nacre_compile_template, nullptr);
    EXPECT_NE(&nacre_pack_lights, nullptr);
    EXPECT_NE(&nacre_library_held_ends, nullptr);
}

}  // namespace
