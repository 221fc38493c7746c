// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include "film/fields.h"
#include "film/film_program.h"
#include "film/solid_index.h"
#include "nacre/core/diagnostics.h"
#include "nacre/kinds/film.h"
#include "nacre/lut/film_table.h"
#include "nacre/lut/inner_tables.h"
#include "nacre/lut/rough_glass_tables.h"
#include "nacre/lut/schlick_fit.h"

namespace nacre::kinds {
namespace film {
namespace {

/// Of smooth tables. What is lost to rounding is 0.002 of ΔE00 on average, a quarter of what their
/// rows are allowed, and their files are a quarter as large.
constexpr int kTexelBits = 13;

/// R, and what light needs that goes on below the film, smooth and rough.
/// @param solid  solid_index() of a film on glass
std::vector<lut::Table> film_tables(const lut::FilmTableRequest& request, Interior below,
                                    std::optional<double> solid)
{
    lut::FilmTableRequest rounded = request;
    rounded.texel_bits = kTexelBits;
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

/// Problems of the bake belong to the template as a whole.
template <class Bake>
auto bake(const MaterialTemplate& source, Bake&& work)
{
    try {
        return work();
    } catch (const InputError& error) {
        std::vector<Diagnostic> problems(error.diagnostics().begin(), error.diagnostics().end());
        for (Diagnostic& problem : problems)
            if (problem.file.empty()) problem.file = source.file;
        throw InputError(std::move(problems));
    }
}

/// Tables of the substrate alone, where coverage fades the film.
void add_bare_tables(lut::FilmTableRequest request, const MaterialTemplate& source,
                     std::optional<double> solid, std::vector<lut::Table>& tables)
{
    if (source.parameter(kCoverage.name) == nullptr) return;
    request.stack.layers.clear();
    request.variation.reset();
    request.progress = nullptr;
    for (lut::Table& table : film_tables(request, film_of(source).interior(), solid)) {
        table.role.is_bare = true;
        tables.push_back(std::move(table));
    }
}

/// What the lobe of clear glass brings along, over slices as wide as those of the film.
void add_lobe_tables(double index, std::vector<lut::Table>& tables)
{
    const lut::Table& rough =
        *std::ranges::find(tables, TableRole{TableOf::R, TableContent::rough}, &lut::Table::role);
    std::vector<lut::Table> lobes =
        lut::bake_lobe_tables(index, rough.x.texels / (rough.sides * rough.slices));
    std::ranges::move(lobes, std::back_inserter(tables));
}

}  // namespace
}  // namespace film

Prepared Film::prepare(const MaterialTemplate& source, const CompileOptions& options) const
{
    const lut::FilmTableRequest request = film_request(source, options);
    return film::bake(source, [&] {
        const std::optional<double> solid = film::solid_index(source, options.range);
        Prepared result{.program = {}, .tables = film::film_tables(request, interior(), solid)};
        std::optional<oslgen::PowerLobes> powers;
        if (solid) {
            film::add_lobe_tables(*solid, result.tables);
        } else {
            lut::SchlickFit fit = lut::fit_schlick(request, result.tables.front());
            result.tables.push_back(std::move(fit.coefficients));
            powers = {std::move(fit.exponents), std::move(fit.bare), fit.error_max, fit.error_rms};
        }
        film::add_bare_tables(request, source, solid, result.tables);
        result.program = film::program(source, result.tables, solid, std::move(powers));
        return result;
    });
}

}  // namespace nacre::kinds
