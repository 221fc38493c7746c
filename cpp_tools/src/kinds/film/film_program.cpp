// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "film/film_program.h"

#include <algorithm>
#include <utility>

#include "film/fields.h"

namespace nacre::kinds::film {
namespace {

using oslgen::Socket;

oslgen::TableInfo::Axis axis_info(const lut::Axis& axis)
{
    return {axis.name, axis.unit, axis.min, axis.max, axis.texels};
}

oslgen::TableInfo table_info(const lut::Table& table, const std::string& id)
{
    return {.role = table.role,
            .file = id + "_" + table.name() + ".exr",
            .quantity = table.quantity,
            .x = axis_info(table.x),
            .y = axis_info(table.y),
            .error_max = table.error_max,
            .error_mean = table.error_mean,
            .lowest = *std::ranges::min_element(table.texels),
            .error_unit = table.error_unit,
            .slices = table.slices,
            .sides = table.sides};
}

void add_thickness(const Film& film, std::vector<Socket>& sockets)
{
    if (const auto layer = film.varying_layer())
        sockets.push_back(oslgen::slider_socket(kThickness.info, film.layers[*layer].thickness_nm));
    if (film.scale) sockets.push_back(oslgen::slider_socket(kScale.info, *film.scale));
    if (!sockets.empty()) sockets.back().name = film.driven_socket();
}

void add_brush(double anisotropy, std::vector<Socket>& sockets)
{
    const material::FieldInfo& info = kAnisotropy.info;
    sockets.push_back(oslgen::slider_socket(
        info, {.value = anisotropy, .min = info.bounds.min, .max = info.bounds.max}));
    sockets.push_back(oslgen::slider_socket(
        {.name = "rotation", .label = "Rotation", .help = "Turns the tangent; 1: once around"}));
}

std::vector<Socket> sockets(const Film& film, const MaterialTemplate& source, bool has_powers)
{
    std::vector<Socket> result;
    add_thickness(film, result);
    if (source.parameter(kCoverage.name)) result.push_back(oslgen::slider_socket(kCoverage));
    if (film.diffuse_base) {
        const material::FieldInfo& base = kDiffuseBase.info;
        result.push_back(oslgen::colour_socket("base_colour", std::string(base.label),
                                               std::string(base.help), *film.diffuse_base));
    }
    result.push_back(oslgen::roughness_socket(source));
    if (film.anisotropy) add_brush(*film.anisotropy, result);
    if (has_powers)
        result.push_back({.name = "exact_rough",
                          .label = "Exact Rough (OSL)",
                          .type = "int",
                          .unit = "1",
                          .description = "1: the film's colour at each microfacet, in twice the "
                                         "time; 0: their mean. OSL only, from roughness 0.1 on"});
    result.push_back(oslgen::normal_socket());
    if (film.anisotropy)
        result.push_back(
            {.name = "tangent",
             .label = "Tangent",
             .type = "tangent",
             .unit = "1",
             .description = "Direction of the brush; unlinked: around the object's Z"});
    return result;
}

decltype(oslgen::TableSurface::below) below(const Film& film, std::optional<double> solid_index)
{
    switch (film.interior()) {
        case Interior::opaque:
            return oslgen::OpaqueBase{};
        case Interior::thin_wall:
            return oslgen::ThinWall{};
        case Interior::solid:
            return oslgen::SolidGlass{solid_index.value()};
        case Interior::diffuse:
            return oslgen::MattBase{};
    }
    return oslgen::OpaqueBase{};
}

}  // namespace

oslgen::Program program(const MaterialTemplate& source, std::span<const lut::Table> tables,
                        std::optional<double> solid_index, std::optional<oslgen::PowerLobes> powers)
{
    const Film& film = film_of(source);
    oslgen::Program result;
    result.sockets = sockets(film, source, powers.has_value());
    result.more["technique"] = technique_name(film.technique);
    if (powers)
        result.more["schlick"] = {
            {"exponents", powers->exponents},
            {"error", {{"max", powers->error_max}, {"rms", powers->error_rms}}}};
    oslgen::TableSurface surface{.tables = {},
                                 .below = below(film, solid_index),
                                 .is_brushed = film.anisotropy.has_value(),
                                 .fades = source.parameter(kCoverage.name) != nullptr,
                                 .powers = std::move(powers)};
    for (const lut::Table& table : tables) surface.tables.push_back(table_info(table, source.id));
    result.body = std::move(surface);
    return result;
}

}  // namespace nacre::kinds::film
