// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/image.h"

#include <nlohmann/json.hpp>

#include "nacre/core/version.h"
#include "shared/held_ends.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;

/// Names of the Color Interop Forum; `unknown` where a space is a config's own.
std::string interop_id(const TableProvenance& provenance)
{
    if (!provenance.built_in_space) return "unknown";
    if (provenance.space.name == "xyz_d65") return "lin_ciexyzd65_scene";
    return provenance.space.name;
}

}  // namespace

Image table_image(const lut::Table& table)
{
    return {table.x.texels, table.y.texels, table.channels, table.texels};
}

std::string axes_json(const std::vector<lut::Axis>& axes)
{
    ordered_json list = ordered_json::array();
    for (const lut::Axis& axis : axes)
        list.push_back({{"name", axis.name},
                        {"unit", axis.unit},
                        {"min", axis.min},
                        {"max", axis.max},
                        {"mapping", "linear"}});
    return list.dump();
}

Attributes table_attributes(const lut::Table& table, const TableProvenance& provenance)
{
    const ordered_json error = {
        {"max", table.error_max}, {"mean", table.error_mean}, {"unit", table.error_unit}};
    std::vector<lut::Axis> axes{table.x};
    if (table.y.texels > 1) axes.push_back(table.y);
    if (table.slices > 1) axes.push_back({"roughness", "1", 1.0 / table.slices, 1.0, table.slices});
    Attributes attributes{
        {"nacre:schema", kTableSchema},
        {"nacre:version", std::string(version())},
        {"nacre:axes", axes_json(axes)},
        {"nacre:quantity", table.quantity},
        {"nacre:stack", provenance.stack},
        {"nacre:illuminant", provenance.illuminant},
        {"nacre:observer", std::string(spectral::observer_name(provenance.observer))},
        {"nacre:adaptation", spectral::adaptation_name(provenance.adaptation)},
        {"nacre:space", provenance.space.name},
        {"nacre:error", error.dump()},
        {"colorInteropID", interop_id(provenance)},
        {"wrapmodes", "clamp,clamp"}};
    if (!provenance.held.empty()) attributes["nacre:held_ends"] = held_json(provenance.held).dump();
    if (const auto& xy = provenance.space.chromaticities)
        attributes["chromaticities"] = std::vector<float>(xy->begin(), xy->end());
    return attributes;
}

}  // namespace nacre::tool
