// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/bands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bands/bands_handle.h"
#include "bands/light_from.h"
#include "base/guard.h"
#include "base/kept_text.h"
#include "nacre/bands/choose.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/spectral/named_spectrum.h"

namespace nacre::capi {
namespace {

using bands::Fine, bands::Light;

std::vector<Light> lights_from(std::size_t count, const nacre_light* given)
{
    std::vector<Light> lights;
    if (count > 0) require(given, "light");
    for_each_item(count, [&](std::size_t i) { lights.push_back(light_from(given[i])); });
    return lights;
}

std::vector<Fine> rows_of(std::size_t rows, std::size_t samples, const double* wavelength_nm,
                          const double* values, const char* field)
{
    std::vector<Fine> read;
    for_each_item(rows, [&](std::size_t i) {
        require(values, field);
        const spectral::Spectrum row =
            samples_of(samples, wavelength_nm, values + i * samples, field);
        read.push_back(row.values_at(bands::fine_grid(), row.recommended()));
    });
    return read;
}

std::vector<Fine> library_reflectances()
{
    std::vector<Fine> found;
    for (const std::string& key : spectral::library_spectrum_keys()) {
        const spectral::NamedSpectrum& spectrum = spectral::library_spectrum(key);
        if (spectrum.kind == spectral::SpectrumKind::reflectance)
            found.push_back(spectrum.values_at(bands::fine_grid()));
    }
    return found;
}

/// Those of one thickness are one film.
std::vector<bands::Film> films_from(const nacre_band_needs& given)
{
    if (given.films > 0) require(given.film_nm, "film_nm");
    std::vector<Fine> reflectances;
    if (given.film_reflectance)
        reflectances = rows_of(given.films, given.samples, given.wavelength_nm,
                               given.film_reflectance, "film_reflectance");
    std::vector<bands::Film> films;
    for (std::size_t i = 0; i < given.films; ++i) {
        const double thickness_nm = given.film_nm[i];
        if (!(thickness_nm > 0.0) || std::isinf(thickness_nm))
            fail("film_nm", fmt::format("must be finite and > 0 (got {:g})", thickness_nm));
        auto film = std::ranges::find(films, thickness_nm, &bands::Film::optical_thickness_nm);
        if (film == films.end()) film = films.insert(films.end(), {thickness_nm, {}});
        if (given.film_reflectance) film->reflectances.push_back(std::move(reflectances[i]));
    }
    return films;
}

bands::Needs needs_from(const nacre_band_needs& given)
{
    for (const double error : {given.mean_error, given.max_error})
        if (!(error > 0.0)) fail("error", fmt::format("must be > 0 (got {:g})", error));
    bands::Needs needs{
        .lights = lights_from(given.lights, given.light),
        .reflectances = rows_of(given.reflectances, given.samples, given.wavelength_nm,
                                given.reflectance, "reflectance"),
        .films = films_from(given),
        .spreads = {},
        .mean_error = given.mean_error,
        .max_error = given.max_error};
    if (given.reflectances == 0) needs.reflectances = library_reflectances();
    for (Fine& spread :
         rows_of(given.spreads, given.samples, given.wavelength_nm, given.spread_px, "spread_px"))
        needs.spreads.push_back({std::move(spread)});
    return needs;
}

int count_of(std::size_t count)
{
    return static_cast<int>(std::min<std::size_t>(count, 1'000'000));
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_bands_make(size_t count, size_t lights, const nacre_light* light,
                              const char* observer, nacre_bands** bands)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(observer, "observer");
        capi::require(bands, "bands");
        nacre_bands made{bands::make_bands(capi::count_of(count), capi::lights_from(lights, light),
                                           spectral::observer_from_name(observer))};
        *bands = std::make_unique<nacre_bands>(std::move(made)).release();
    });
}

nacre_status nacre_bands_choose(const nacre_band_needs* needs, const char* observer,
                                nacre_bands** bands, nacre_band_choice* choice)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(needs, "needs");
        capi::require(observer, "observer");
        capi::require(bands, "bands");
        capi::require(choice, "choice");
        bands::Choice made =
            bands::choose_bands(capi::needs_from(*needs), spectral::observer_from_name(observer));
        *choice = {.passes = made.passes,
                   .mean_error = made.error.mean,
                   .max_error = made.error.max,
                   .film_error = made.films,
                   .step_px = made.step_px,
                   .held = capi::kept(made.held),
                   .met = made.met ? 1 : 0};
        *bands = std::make_unique<nacre_bands>(nacre_bands{std::move(made.bands)}).release();
    });
}

size_t nacre_bands_count(const nacre_bands* bands)
{
    return bands == nullptr ? 0 : bands->made.size();
}

nacre_status nacre_bands_get(const nacre_bands* bands, double* edges_nm, double* wavelength_nm,
                             double* xyz, unsigned char* is_line)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(edges_nm, "edges_nm");
        capi::require(wavelength_nm, "wavelength_nm");
        capi::require(xyz, "xyz");
        *edges_nm++ = spectral::kFirstNm;
        for (const bands::Band& band : bands->made.bands) {
            *edges_nm++ = band.last_nm;
            *wavelength_nm++ = band.wavelength_nm;
            xyz = std::copy(band.xyz.begin(), band.xyz.end(), xyz);
            if (is_line != nullptr) *is_line++ = band.is_line ? 1 : 0;
        }
    });
}

nacre_status nacre_light_in_bands(const nacre_bands* bands, const nacre_light* light, double* power)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(light, "light");
        capi::require(power, "power");
        const auto found = bands::light_in_bands(bands->made, capi::light_from(*light));
        std::copy(found.begin(), found.end(), power);
    });
}

nacre_status nacre_band_error(const nacre_bands* bands, const nacre_light* light, size_t samples,
                              const double* wavelength_nm, size_t reflectances,
                              const double* reflectance, double* mean, double* max)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(light, "light");
        capi::require(mean, "mean");
        capi::require(max, "max");
        if (reflectances == 0) capi::fail("reflectances", "must be one or more");
        const auto rows =
            capi::rows_of(reflectances, samples, wavelength_nm, reflectance, "reflectance");
        const bands::BandError error =
            bands::band_error(bands->made, capi::light_from(*light), rows);
        *mean = error.mean;
        *max = error.max;
    });
}

void nacre_bands_free(nacre_bands* bands)
{
    delete bands;  // NOLINT(cppcoreguidelines-owning-memory): the caller's handle
}
}
