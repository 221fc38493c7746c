// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/guard.h"
#include "nacre/capi/films.h"

namespace nacre::capi {
namespace {

using optics::Polarisation;

double cosine(double angle_deg)
{
    if (!(angle_deg >= 0.0 && angle_deg < 90.0))
        fail("angle_deg", fmt::format("must be in [0, 90) (got {})", angle_deg));
    return std::cos(angle_deg * std::numbers::pi / 180.0);
}

double reflectance(optics::FilmModel model, const nacre_film_query& query, Polarisation which)
{
    const optics::SingleFilm film{.n_ambient = query.n_ambient,
                                  .n_film = query.n_film,
                                  .n_base = {query.n_base, query.k_base},
                                  .thickness_nm = query.d_nm};
    const optics::Incidence light{cosine(query.angle_deg), query.wavelength_nm, which};
    if (model == optics::FilmModel::etalon && query.mirror_reflectance >= 0.0)
        return etalon_reflectance(film, light, query.mirror_reflectance);
    return film_reflectance(model, film, light);
}

double reflectance(optics::FilmModel model, const nacre_film_query& query,
                   nacre_polarisation polarisation)
{
    if (polarisation == NACRE_S) return reflectance(model, query, Polarisation::s);
    if (polarisation == NACRE_P) return reflectance(model, query, Polarisation::p);
    return 0.5 * (reflectance(model, query, Polarisation::s) +
                  reflectance(model, query, Polarisation::p));
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_film_reflectance(const char* model, size_t count, const nacre_film_query* films,
                                    nacre_polarisation polarisation, double* R)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(model, "model");
        const optics::FilmModel form = optics::film_model_from_name(model);
        if (count == 0) return;
        capi::require(films, "films");
        capi::require(R, "R");
        if (polarisation < NACRE_S || polarisation > NACRE_UNPOLARISED)
            capi::fail("polarisation", "must be s, p or u");
        std::vector<double> results(count);
        capi::for_each_item(count, [&](std::size_t i) {
            results[i] = capi::reflectance(form, films[i], polarisation);
        });
        std::copy(results.begin(), results.end(), R);
    });
}
}
