// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/compile.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "media.h"
#include "nacre/oslgen/material_program.h"
#include "nacre/pipeline/shader_tables.h"
#include "nacre/spectral/wavelength_sampling.h"

namespace nacre::pipeline {
namespace {

using material::GlassSpec;
using material::GratingSpec;
using material::MaterialTemplate;
using material::StackSpec;

// Fraunhofer lines of the Abbe number: ISO 7944.
constexpr double kLineF = 486.1327, kLineD = 587.5618, kLineC = 656.2725;

// Knots of a glass: cubics between them stay within 1e-7 of any Sellmeier curve of a clear medium.
constexpr double kKnotStepNm = 10.0;
constexpr int kKnots = 48;

// A clear medium's data sheet may list a trace of absorption.
constexpr double kTraceOfK = 1e-4;

spectral::ColourWeights colour_weights(const CompileOptions& options)
{
    const spectral::ColourSpace& space =
        options.custom_space ? *options.custom_space : spectral::colour_space(options.space);
    return spectral::reflectance_weights(spectral::named_illuminant(options.illuminant),
                                         options.observer, space);
}

std::optional<lut::Variation> variation(const StackSpec& stack)
{
    if (const auto layer = stack.varying_layer()) {
        const material::Quantity& thickness = stack.layers[*layer].thickness_nm;
        return lut::Variation{layer, thickness.min.value(), thickness.max.value()};
    }
    if (stack.scale)
        return lut::Variation{std::nullopt, stack.scale->min.value(), stack.scale->max.value()};
    return std::nullopt;
}

lut::SampledStack sampled_stack(const StackSpec& stack, const std::string& file)
{
    MediaReader media(file);
    lut::SampledStack result{
        .ambient = media.clear_on_grid(stack.ambient, kTraceOfK), .layers = {}, .substrate = {}};
    for (const material::LayerSpec& layer : stack.layers)
        result.layers.push_back(
            {media.on_grid(layer.medium), layer.thickness_nm.value, layer.coherent});
    result.substrate = media.on_grid(stack.substrate);
    media.throw_if_any();
    return result;
}

oslgen::TableInfo::Axis axis_info(const lut::Axis& axis)
{
    return {axis.name, axis.unit, axis.min, axis.max, axis.texels};
}

oslgen::TableInfo table_info(const lut::Table& table, const std::string& id)
{
    return {.name = table.name,
            .file = id + "_" + table.name + ".exr",
            .quantity = table.quantity,
            .x = axis_info(table.x),
            .y = axis_info(table.y),
            .error_max = table.error_max,
            .error_mean = table.error_mean,
            .lowest = *std::ranges::min_element(table.texels)};
}

void append_tables(lut::FilmTables&& baked, const std::string& suffix,
                   std::vector<lut::Table>& tables)
{
    baked.reflectance.name = "R" + suffix;
    tables.push_back(std::move(baked.reflectance));
    if (!baked.transmittance) return;
    baked.transmittance->name = "T" + suffix;
    tables.push_back(std::move(*baked.transmittance));
}

/// Problems of the bake belong to the template as a whole.
lut::FilmTables bake(const lut::FilmTableRequest& request, const std::string& file)
{
    try {
        return lut::bake_film_tables(request);
    } catch (const InputError& error) {
        std::vector<Diagnostic> problems(error.diagnostics().begin(), error.diagnostics().end());
        for (Diagnostic& problem : problems)
            if (problem.file.empty()) problem.file = file;
        throw InputError(std::move(problems));
    }
}

std::vector<lut::Table> bake_all(const MaterialTemplate& source, const CompileOptions& options)
{
    lut::FilmTableRequest request = film_request(source, options);
    std::vector<lut::Table> tables;
    append_tables(bake(request, source.file), "", tables);
    if (source.parameter("coverage")) {
        request.stack.layers.clear();
        request.variation.reset();
        request.progress = nullptr;
        append_tables(bake(request, source.file), "_bare", tables);
    }
    return tables;
}

oslgen::WavelengthTable wavelength_table(const spectral::ColourWeights& weights)
{
    spectral::WavelengthSampling sampling = spectral::sample_wavelengths(weights, kWavelengthCells);
    return {std::move(sampling.edges_nm), std::move(sampling.weight)};
}

/// Colour of the metal under its cover at normal incidence.
oslgen::GratingColours grating_colours(const GratingSpec& grating, const std::string& file,
                                       const spectral::ColourWeights& weights)
{
    MediaReader media(file);
    lut::FilmTableRequest request;
    request.stack.ambient = media.clear_on_grid(grating.cover, kTraceOfK);
    request.stack.substrate = media.on_grid(grating.substrate);
    request.weights = weights;
    media.throw_if_any();
    const double cover_index = media.constants(grating.cover)->at(kLineD).real();
    return {lut::exact_film_colour(request, 1.0, 0.0).reflectance, cover_index};
}

oslgen::GlassIndex glass_index(const GlassSpec& glass, const std::string& file,
                               const spectral::ColourWeights& weights)
{
    MediaReader media(file);
    const lut::IndexOnGrid index = media.clear_on_grid(glass.medium, kTraceOfK);
    media.throw_if_any();
    const spectral::OpticalConstantsPtr medium = media.constants(glass.medium);
    spectral::Sampled n{};
    std::ranges::transform(index, n.begin(), [](const auto& value) { return value.real(); });

    oslgen::GlassIndex result{.first_nm = spectral::kFirstNm,
                              .step_nm = kKnotStepNm,
                              .knots = {},
                              .mean_rgb = weights.apply(n),
                              .n_F = medium->at(kLineF).real(),
                              .n_d = medium->at(kLineD).real(),
                              .n_C = medium->at(kLineC).real()};
    for (int i = 0; i < kKnots; ++i)
        result.knots.push_back(medium->at(spectral::kFirstNm + i * kKnotStepNm).real());
    return result;
}

}  // namespace

lut::FilmTableRequest film_request(const MaterialTemplate& source, const CompileOptions& options)
{
    const auto* stack = std::get_if<StackSpec>(&source.kind);
    if (!stack)
        throw InputError(Diagnostic{source.file, 0, "",
                                    "must be a film: [ambient], [[layer]], "
                                    "[substrate]"});
    lut::FilmTableRequest request;
    request.stack = sampled_stack(*stack, source.file);
    request.variation = variation(*stack);
    request.weights = colour_weights(options);
    request.tolerance = options.tolerance;
    request.transmittance = source.surface.transmission;
    request.progress = options.progress;
    return request;
}

CompiledMaterial compile(const MaterialTemplate& source, const CompileOptions& options)
{
    oslgen::Context context;
    context.source = &source;
    const spectral::ColourWeights weights = colour_weights(options);
    context.space = weights.space;
    context.illuminant = weights.illuminant;
    context.observer = spectral::observer_name(weights.observer);

    CompiledMaterial result{.id = source.id, .osl = {}, .manifest = {}, .tables = {}};
    if (const auto* grating = std::get_if<GratingSpec>(&source.kind)) {
        context.wavelengths = wavelength_table(weights);
        context.grating = grating_colours(*grating, source.file, weights);
    } else if (const auto* glass = std::get_if<GlassSpec>(&source.kind)) {
        context.wavelengths = wavelength_table(weights);
        context.glass = glass_index(*glass, source.file, weights);
    } else {
        result.tables = bake_all(source, options);
        for (const lut::Table& table : result.tables)
            context.tables.push_back(table_info(table, source.id));
    }
    oslgen::MaterialProgram program = oslgen::generate(context);
    result.osl = std::move(program.osl);
    result.manifest = std::move(program.manifest);
    return result;
}

}  // namespace nacre::pipeline
