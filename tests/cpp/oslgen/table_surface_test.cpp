// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/table_surface.h"

#include <gtest/gtest.h>

namespace nacre::oslgen {
namespace {

TableInfo table(const TableRole& role, double lowest = 0.0, int height = 1)
{
    return {.role = role,
            .file = "",
            .quantity = "",
            .x = {"cos_theta", "1", 0.0, 1.0, 8},
            .y = {"thickness_nm", "nm", 0.0, 9.0, height},
            .error_max = 0.0,
            .error_mean = 0.0,
            .lowest = lowest};
}

constexpr TableRole kR{TableOf::R}, kBare{TableOf::R, TableContent::smooth, true},
    kRough{TableOf::R, TableContent::rough}, kFurther{TableOf::R, TableContent::further};

TEST(TableSurface, FadesWhereItMayAndABareTableIsThere)
{
    TableSurface surface{.tables = {table(kR), table(kBare)}, .below = OpaqueBase{}};
    EXPECT_FALSE(surface.faded(TableOf::R).bare.has_value());
    surface.fades = true;
    EXPECT_TRUE(surface.faded(TableOf::R).bare.has_value());
    surface.tables.pop_back();
    EXPECT_FALSE(surface.faded(TableOf::R).bare.has_value());
}

TEST(TableSurface, ReadsFurtherBouncesApartOnlyWhereItIsBrushed)
{
    TableSurface surface{.tables = {table(kR), table(kRough), table(kFurther)},
                         .below = OpaqueBase{}};
    EXPECT_TRUE(surface.colour(TableOf::R).rough.has_value());
    EXPECT_FALSE(surface.colour(TableOf::R).further.has_value());
    surface.is_brushed = true;
    EXPECT_TRUE(surface.colour(TableOf::R).further.has_value());
    EXPECT_EQ(surface.further_bounces().size(), 1u);
}

TEST(TableSurface, HasARowWhereSomethingVaries)
{
    const TableSurface still{.tables = {table(kR)}, .below = OpaqueBase{}};
    EXPECT_FALSE(still.row().has_value());
    const TableSurface varying{.tables = {table(kR, 0.0, 4)}, .below = OpaqueBase{}};
    EXPECT_EQ(varying.row()->name, "thickness_nm");
}

TEST(TableSurface, KnowsWhetherReflectionLeavesTheGamut)
{
    const auto has_negative = [](const TableRole& role) {
        return TableSurface{.tables = {table(kR), table(role, -0.1)}, .below = OpaqueBase{}}
            .has_negative();
    };
    EXPECT_TRUE(has_negative(kRough));
    EXPECT_TRUE(has_negative(kBare));
    EXPECT_FALSE(has_negative({TableOf::T}));
    EXPECT_FALSE(has_negative({TableOf::R, TableContent::powers}));
}

TEST(TableSurface, HasPowersOfTheBareSubstrateWhereItFades)
{
    TableSurface surface{.tables = {table(kR)}, .below = OpaqueBase{}};
    surface.powers = PowerLobes{
        .exponents = {0.0}, .bare = {{0.1, 0.2, 0.3}}, .error_max = 0.0, .error_rms = 0.0};
    EXPECT_TRUE(surface.bare_powers().empty());
    surface.tables.push_back(table(kBare));
    EXPECT_EQ(surface.bare_powers().size(), 1u);
}

TEST(TableSurface, HasAnIndexOnGlassAlone)
{
    const TableSurface glass{.tables = {table(kR)}, .below = SolidGlass{1.5}};
    EXPECT_EQ(glass.solid_index(), 1.5);
    const TableSurface wall{.tables = {table(kR)}, .below = ThinWall{}};
    EXPECT_FALSE(wall.solid_index().has_value());
}

TEST(TableSurface, IsLookedUpOutsideButForItsRoughTables)
{
    EXPECT_TRUE(is_looked_up(table(kR)));
    EXPECT_TRUE(is_looked_up(table(kFurther)));
    EXPECT_FALSE(is_looked_up(table(kRough)));
}

}  // namespace
}  // namespace nacre::oslgen
