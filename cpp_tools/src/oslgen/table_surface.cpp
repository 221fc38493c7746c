// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/table_surface.h"

#include <algorithm>

namespace nacre::oslgen {
namespace {

std::optional<TableInfo> copy_of(const TableInfo* table)
{
    return table ? std::optional(*table) : std::nullopt;
}

}  // namespace

const TableInfo* TableSurface::find(const TableRole& role) const
{
    const auto it = std::ranges::find(tables, role, &TableInfo::role);
    return it == tables.end() ? nullptr : &*it;
}

TableColour TableSurface::colour(TableOf of, bool is_bare) const
{
    const auto table = [&](TableContent form) { return copy_of(find({of, form, is_bare})); };
    TableColour result{table(TableContent::smooth).value(), table(TableContent::rough), {}};
    if (is_brushed && result.rough) result.further = table(TableContent::further);
    return result;
}

FadedColour TableSurface::faded(TableOf of) const
{
    FadedColour result{colour(of), {}};
    if (fades && find({of, TableContent::smooth, true})) result.bare = colour(of, true);
    return result;
}

std::vector<TableInfo> TableSurface::further_bounces() const
{
    std::vector<TableInfo> result;
    for (const bool is_bare : {false, true})
        if (const TableInfo* table = find({TableOf::R, TableContent::further, is_bare}))
            result.push_back(*table);
    return result;
}

std::vector<std::array<double, 3>> TableSurface::bare_powers() const
{
    if (!powers || !find({TableOf::R, TableContent::smooth, true})) return {};
    return powers->bare;
}

std::optional<TableInfo::Axis> TableSurface::row() const
{
    const TableInfo::Axis& axis = find({TableOf::R})->y;
    return axis.texels > 1 ? std::optional(axis) : std::nullopt;
}

std::optional<double> TableSurface::solid_index() const
{
    const auto* glass = std::get_if<SolidGlass>(&below);
    return glass ? std::optional(glass->index) : std::nullopt;
}

bool TableSurface::has_negative() const
{
    return std::ranges::any_of(tables, [](const TableInfo& table) {
        const TableRole& role = table.role;
        const bool is_mean =
            role.content == TableContent::smooth || role.content == TableContent::rough;
        return role.of == TableOf::R && is_mean && table.lowest < 0.0;
    });
}

bool is_looked_up(const TableInfo& table)
{
    return table.role.content != TableContent::rough;
}

}  // namespace nacre::oslgen
