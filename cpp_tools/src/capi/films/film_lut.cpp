// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>

#include "base/guard.h"
#include "colour/colour_maker.h"
#include "nacre/capi/films.h"
#include "nacre/library/lights.h"
#include "nacre/lut/film_table.h"
#include "tables/result.h"

namespace nacre::capi {
namespace {

/// Medium `j` of the caller's array.
lut::IndexOnGrid index_on_grid(const nacre_film& film, std::size_t j)
{
    lut::IndexOnGrid n;
    const double* pairs = film.n + 2 * n.size() * j;
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = {pairs[2 * i], pairs[2 * i + 1]};
    return n;
}

void check(const nacre_film& film)
{
    require(film.n, "n");
    if (film.layers > 0) require(film.d_nm, "d_nm");
    require(film.illuminant, "illuminant");
    require(film.observer, "observer");
    require(film.space, "space");
    if (film.layers > optics::kMaxLayers)
        fail("d_nm",
             fmt::format("must have at most {} layers (got {})", optics::kMaxLayers, film.layers));
    if (film.varying < -2)
        fail("varying", "must be the index of a layer, -1 (scale) or -2 (nothing)");
}

lut::FilmTableRequest film_request(const nacre_film& film)
{
    check(film);
    lut::FilmTableRequest request;
    request.stack.ambient = index_on_grid(film, 0);
    request.stack.substrate = index_on_grid(film, film.layers + 1);
    for (std::size_t j = 0; j < film.layers; ++j)
        request.stack.layers.push_back(
            {.n = index_on_grid(film, j + 1),
             .thickness_nm = film.d_nm[j],
             .coherent = film.coherent == nullptr || film.coherent[j] != 0});
    if (film.varying != -2) {
        request.variation = lut::Variation{.layer = {}, .min = film.min, .max = film.max};
        if (film.varying >= 0) request.variation->layer = static_cast<std::size_t>(film.varying);
    }
    request.weights = spectral::reflectance_weights(
        spectral::named_illuminant(film.illuminant), spectral::observer_from_name(film.observer),
        spectral::colour_space(film.space), adaptation_or_bradford(film.adaptation));
    if (film.width > 0 || film.height > 0) request.size = {film.width, film.height};
    request.measure_error = !(request.size && film.tolerance == 0.0);
    if (request.measure_error) request.tolerance = film.tolerance;
    request.transmittance = film.transmittance != 0;
    if (film.single_precision != 0) {
        if (request.measure_error)
            fail("single_precision", "must be 0 where errors are measured: their truth is double");
        request.precision = lut::Precision::single_precision;
    }
    return request;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_film_lut(const nacre_film* film, nacre_result** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(film, "film");
        capi::require(result, "result");
        auto tables = lut::bake_film_tables(capi::film_request(*film));
        auto made = std::make_unique<nacre_result>();
        made->tables.push_back(std::move(tables.reflectance));
        if (tables.transmittance) made->tables.push_back(std::move(*tables.transmittance));
        *result = made.release();
    });
}
}
