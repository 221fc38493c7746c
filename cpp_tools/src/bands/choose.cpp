// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/choose.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>

#include "eye.h"
#include "nacre/core/diagnostics.h"
#include "nacre/spectral/colour.h"

namespace nacre::bands {

using spectral::Vec3;

namespace {

constexpr double kSeen = 0.1;  ///< of the brightest: what is darker may take wider steps

// Of white's Y: under sodium Z says nothing, and Z of a surface over Z of white is noise.
constexpr double kNoResponse = 1e-4;

double read_at(const Fine& values, double nm)
{
    const double x = (nm - spectral::kFirstNm) / kStepNm - 0.5;
    const double clamped = std::clamp(x, 0.0, static_cast<double>(kFineWavelengths - 1));
    const auto i = std::min(static_cast<std::size_t>(clamped), kFineWavelengths - 2);
    return values[i] + (clamped - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

/// ∫ CMF S R dλ, with lines as they are.
Vec3 exact_xyz(const Eye& seen, const Light& light, const Fine* reflectance)
{
    Vec3 sum{};
    const auto add = [&sum](const Vec3& xyz, double value) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += xyz[c] * value;
    };
    for (std::size_t i = 0; i < light.power.size(); ++i)
        add(seen.xyz[i], light.power[i] * kStepNm * (reflectance ? (*reflectance)[i] : 1.0));
    for (const spectral::SpectralLine& line : light.lines)
        add(seen.at(line.wavelength_nm),
            line.power * (reflectance ? read_at(*reflectance, line.wavelength_nm) : 1.0));
    return sum;
}

/// The widest step in pixels between neighbouring wavelengths that are bright enough to be seen.
double widest_step(const Bands& bands, const Spread& spread)
{
    const auto luminance = [](const Band& band) {
        return band.xyz[1] / (band.last_nm - band.first_nm);
    };
    double brightest = 0.0, widest = 0.0;
    for (const Band& band : bands.bands) brightest = std::max(brightest, luminance(band));
    for (std::size_t k = 1; k < bands.size(); ++k) {
        const Band &here = bands.bands[k], &before = bands.bands[k - 1];
        if (std::min(luminance(here), luminance(before)) < kSeen * brightest) continue;
        widest = std::max(widest, std::abs(read_at(spread.position_px, here.wavelength_nm) -
                                           read_at(spread.position_px, before.wavelength_nm)));
    }
    return widest;
}

/// A surface as the bands have it.
using Reading = std::function<double(std::size_t band, const Fine& reflectance)>;

BandError error_of(const Bands& bands, const Light& light, std::span<const Fine> reflectances,
                   const Reading& read)
{
    assert(!reflectances.empty());
    const Eye& seen = eye(bands.observer);
    const Vec3 white = exact_xyz(seen, light, nullptr);
    const std::vector<double> power = light_in_bands(bands, light);
    const auto lab = [&white](Vec3 xyz) {
        Vec3 relative = white;
        for (const std::size_t c : {0U, 2U})
            if (white[c] <= kNoResponse * white[1]) xyz[c] = xyz[1], relative[c] = white[1];
        for (std::size_t c = 0; c < 3; ++c) {
            xyz[c] /= white[1];
            relative[c] /= white[1];
        }
        return spectral::xyz_to_lab(xyz, relative);
    };
    BandError error{.mean = 0.0, .max = 0.0};
    std::vector<double> reflected(bands.size());
    for (const Fine& reflectance : reflectances) {
        assert(reflectance.size() == kFineWavelengths);
        for (std::size_t k = 0; k < bands.size(); ++k)
            reflected[k] = power[k] * read(k, reflectance);
        const double difference = spectral::delta_e_2000(lab(bands.xyz(reflected)),
                                                         lab(exact_xyz(seen, light, &reflectance)));
        error.mean += difference / static_cast<double>(reflectances.size());
        error.max = std::max(error.max, difference);
    }
    return error;
}

double film_error(const Bands& bands, const Light& light, const Film& film)
{
    std::vector<spectral::Sampled> weights;
    for (std::size_t k = 0; k < bands.size(); ++k)
        weights.push_back(film_weights(bands, k, film.optical_thickness_nm));
    const auto read = [&weights](std::size_t band, const Fine& reflectance) {
        double sum = 0.0;
        for (std::size_t i = 0; i < spectral::kWavelengths; ++i)
            if (weights[band][i] != 0.0)
                sum += weights[band][i] * read_at(reflectance, spectral::wavelength_nm(i));
        return sum;
    };
    return error_of(
               bands, light,
               film.reflectances.empty() ? fringes(film.optical_thickness_nm) : film.reflectances,
               read)
        .mean;
}

/// How much of what is allowed each need takes up: 1 is the limit.
struct Load {
    const char* held;
    double load;
};

Choice try_passes(const Needs& needs, int passes, spectral::ObserverId observer)
{
    Choice choice{.passes = passes,
                  .bands = make_bands(3 * passes, needs.lights, observer),
                  .error = {0.0, 0.0},
                  .films = 0.0,
                  .step_px = 0.0,
                  .held = "lights",
                  .met = false};
    for (const Light& light : needs.lights) {
        if (!needs.reflectances.empty()) {
            const BandError error = band_error(choice.bands, light, needs.reflectances);
            choice.error = {std::max(choice.error.mean, error.mean),
                            std::max(choice.error.max, error.max)};
        }
        for (const Film& film : needs.films)
            choice.films = std::max(choice.films, film_error(choice.bands, light, film));
    }
    for (const Spread& spread : needs.spreads)
        choice.step_px = std::max(choice.step_px, widest_step(choice.bands, spread));
    const Load loads[] = {{"lights", std::max(choice.error.mean / needs.mean_error,
                                              choice.error.max / needs.max_error)},
                          {"films", choice.films / needs.mean_error},
                          {"spreads", choice.step_px / kWidestStepPx}};
    const Load& worst = *std::ranges::max_element(loads, {}, &Load::load);
    choice.held = worst.held;
    choice.met = worst.load <= 1.0;
    return choice;
}

}  // namespace

BandError band_error(const Bands& bands, const Light& light, std::span<const Fine> reflectances)
{
    return error_of(bands, light, reflectances, [&bands](std::size_t band, const Fine& surface) {
        return read_at(surface, bands.bands[band].wavelength_nm);
    });
}

std::vector<Fine> fringes(double optical_thickness_nm)
{
    constexpr int kFilms = 9;
    std::vector<Fine> films;
    for (int film = 0; film < kFilms; ++film) {
        const double nd = optical_thickness_nm * (0.9 + 0.2 * film / (kFilms - 1));
        Fine& values = films.emplace_back();
        for (const double nm : fine_grid())
            values.push_back(0.5 - 0.5 * std::cos(4.0 * std::numbers::pi * nd / nm));
    }
    return films;
}

Choice choose_bands(const Needs& needs, spectral::ObserverId observer)
{
    if (needs.lights.empty())
        throw InputError({.file = {}, .field = "lights", .message = "must be one or more"});
    const int fewest = fewest_bands(needs.lights);
    const auto* passes =
        std::ranges::find_if(kPasses, [fewest](int candidate) { return 3 * candidate >= fewest; });
    if (passes == std::end(kPasses)) --passes;  // make_bands() says what is wrong
    Choice choice = try_passes(needs, *passes, observer);
    if (choice.met && passes != std::begin(kPasses)) choice.held = "lines";
    while (!choice.met && ++passes != std::end(kPasses))
        choice = try_passes(needs, *passes, observer);
    return choice;
}

}  // namespace nacre::bands
