// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <utility>

#include "film/solid_index.h"
#include "film/technique.h"
#include "nacre/core/diagnostics.h"
#include "nacre/kinds/film.h"
#include "nacre/kinds/media_reader.h"

namespace nacre::kinds {
namespace film {
namespace {

// Its jumps leave a kink at every cell of wavelengths: the error falls only with the step itself.
constexpr int kMostTexelsOfBands = 512;

std::optional<lut::Variation> variation(const Film& film)
{
    if (const auto layer = film.varying_layer()) {
        const material::Quantity& thickness = film.layers[*layer].thickness_nm;
        return lut::Variation{layer, thickness.min.value(), thickness.max.value()};
    }
    if (film.scale)
        return lut::Variation{std::nullopt, film.scale->min.value(), film.scale->max.value()};
    return std::nullopt;
}

lut::SampledStack sampled_stack(const Film& film, bool clear_substrate, MediaReader media)
{
    lut::SampledStack result{
        .ambient = media.clear_on_grid(film.ambient, kTraceOfK), .layers = {}, .substrate = {}};
    for (const LayerSpec& layer : film.layers)
        result.layers.push_back(
            {media.on_grid(layer.medium), layer.thickness_nm.value, layer.coherent});
    result.substrate = clear_substrate ? media.clear_on_grid(film.substrate, kTraceOfK)
                                       : media.on_grid(film.substrate);
    media.throw_if_any();
    return result;
}

}  // namespace

std::optional<double> solid_index(const MaterialTemplate& source, spectral::RangeRule rule)
{
    const Film& film = film_of(source);
    if (film.interior() != Interior::solid) return std::nullopt;
    MediaReader media(source.file, rule);
    const spectral::OpticalConstantsPtr substrate = media.constants(film.substrate),
                                        ambient = media.constants(film.ambient);
    media.throw_if_any();
    return substrate->at(kLineD).real() / ambient->at(kLineD).real();
}

}  // namespace film

lut::FilmTableRequest film_request(const MaterialTemplate& source, const CompileOptions& options)
{
    const Film& film = film_of(source);
    lut::FilmTableRequest request;
    const bool light_goes_on = film.interior() != Interior::opaque;
    request.stack = film::sampled_stack(film, light_goes_on, {source.file, options.range});
    request.technique = film::technique(film, request.stack, source.file);
    request.variation = film::variation(film);
    request.weights = options.weights();
    request.tolerance = options.tolerance;
    request.transmittance = light_goes_on;
    request.progress = options.progress;
    if (film.technique == Technique::path_difference) {
        request.max_texels = film::kMostTexelsOfBands;
        request.accept_error = true;
    }
    return request;
}

}  // namespace nacre::kinds
