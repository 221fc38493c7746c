// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <utility>

#include "film/film_program.h"
#include "film/film_tables.h"
#include "film/solid_index.h"
#include "nacre/kinds/film.h"
#include "nacre/lut/rough_glass_tables.h"
#include "nacre/lut/schlick_fit.h"

namespace nacre::kinds {
namespace film {
namespace {

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
    return film::with_file(source, [&] {
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
        if (film::fades(source))
            std::ranges::move(film::bare_tables(request, film_of(source).interior(), solid),
                              std::back_inserter(result.tables));
        result.program = film::program(source, result.tables, solid, std::move(powers));
        return result;
    });
}

}  // namespace nacre::kinds
