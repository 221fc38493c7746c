// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "film/film_tables.h"

#include <utility>

#include "film/fields.h"
#include "nacre/lut/film_table.h"
#include "nacre/lut/inner_tables.h"
#include "nacre/lut/rough_glass_tables.h"

namespace nacre::kinds::film {

std::vector<lut::Table> film_tables(const lut::FilmTableRequest& request, Interior below,
                                    std::optional<double> solid, int texel_bits)
{
    lut::FilmTableRequest rounded = request;
    rounded.texel_bits = texel_bits;
    lut::FilmTables baked = lut::bake_film_tables(rounded);
    lut::RoughTables rough = solid ? lut::bake_rough_glass_tables(request, baked, *solid)
                                   : lut::bake_rough_tables(request, baked);
    const int height = baked.reflectance.y.texels;
    std::vector<lut::Table> tables{std::move(baked.reflectance), std::move(rough.reflectance)};
    const auto add = [&tables](std::optional<lut::Table>& table) {
        if (table) tables.push_back(std::move(*table));
    };
    add(rough.further);
    add(baked.transmittance);
    add(rough.transmittance);
    if (below == Interior::diffuse) {
        lut::InnerTables inner = lut::bake_inner_tables(request, height);
        tables.push_back(std::move(inner.reflectance));
        tables.push_back(std::move(inner.transmittance));
    }
    return tables;
}

bool fades(const MaterialTemplate& source)
{
    return source.parameter(kCoverage.name) != nullptr;
}

std::vector<lut::Table> bare_tables(lut::FilmTableRequest request, Interior below,
                                    std::optional<double> solid, int texel_bits)
{
    request.stack.layers.clear();
    request.variation.reset();
    request.progress = nullptr;
    std::vector<lut::Table> tables = film_tables(request, below, solid, texel_bits);
    for (lut::Table& table : tables) table.role.is_bare = true;
    return tables;
}

}  // namespace nacre::kinds::film
