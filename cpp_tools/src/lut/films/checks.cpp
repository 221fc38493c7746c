// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "films/checks.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/diagnostics.h"
#include "nacre/optics/film_model_stack.h"
#include "nacre/optics/multilayer.h"

namespace nacre::lut {
namespace {

void check_technique(const FilmTableRequest& request, const optics::FilmStack& at, std::size_t i,
                     DiagnosticList& problems)
{
    if (!request.technique || at.layers.empty() || request.technique->from_below) return;
    for (const optics::StackProblem& problem :
         optics::film_model_problems(request.technique->model, at))
        problems.add({{},
                      0,
                      fmt::format("{}[{}]", problem.field, problem.index),
                      fmt::format("{} for the technique {} (at {} nm)", problem.message,
                                  optics::film_model_name(request.technique->model),
                                  spectral::wavelength_nm(i))});
}

void check_stack(const FilmTableRequest& request, DiagnosticList& problems)
{
    const SampledStack& stack = request.stack;
    optics::FilmStack at{.ambient = {}, .layers = {}, .substrate = {}};
    for (const SampledLayer& layer : stack.layers)
        at.layers.push_back(
            {.n = {}, .thickness_nm = layer.thickness_nm, .coherent = layer.coherent});
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        at.ambient = stack.ambient[i];
        at.substrate = stack.substrate[i];
        for (std::size_t j = 0; j < stack.layers.size(); ++j) at.layers[j].n = stack.layers[j].n[i];
        if (const auto problem = validate(at)) {
            problems.add(
                {{},
                 0,
                 fmt::format("{}[{}]", problem->field, problem->index),
                 fmt::format("{} (at {} nm)", problem->message, spectral::wavelength_nm(i))});
            return;  // the same medium is often wrong at every wavelength
        }
        check_technique(request, at, i, problems);
        if (!problems.empty()) return;
    }
}

}  // namespace

void check(const FilmTableRequest& request)
{
    DiagnosticList problems;
    check_stack(request, problems);
    if (const auto& variation = request.variation) {
        const bool ordered = std::isfinite(variation->min) && std::isfinite(variation->max) &&
                             variation->min >= 0.0 && variation->min < variation->max;
        if (!ordered)
            problems.add({{},
                          0,
                          "variation",
                          fmt::format("must have 0 ≤ min < max, both finite (got {} and {})",
                                      variation->min, variation->max)});
        if (variation->layer && *variation->layer >= request.stack.layers.size())
            problems.add({{},
                          0,
                          "variation",
                          fmt::format("must name one of the {} layers (got layer[{}])",
                                      request.stack.layers.size(), *variation->layer)});
    }
    if (!request.measure_error && !request.size)
        problems.add({{}, 0, "size", "must be given where the error is not measured"});
    if (!(request.tolerance > 0.0))
        problems.add({{}, 0, "tolerance", fmt::format("must be > 0 (got {})", request.tolerance)});
    if (request.max_texels < 2)
        problems.add(
            {{}, 0, "max_texels", fmt::format("must be ≥ 2 (got {})", request.max_texels)});
    if (request.size) {
        const auto [width, height] = *request.size;
        const int least = request.variation ? 2 : 1, most = request.variation ? 16384 : 1;
        if (width < 2 || width > 16384 || height < least || height > most)
            problems.add({{},
                          0,
                          "size",
                          fmt::format("must be 2…16384 texels wide and {}…{} high (got {}x{})",
                                      least, most, width, height)});
    }
    problems.throw_if_any();
}

}  // namespace nacre::lut
