// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/compile.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "media.h"
#include "nacre/library/lights.h"
#include "nacre/lut/inner_tables.h"
#include "nacre/lut/rough_glass_tables.h"
#include "nacre/lut/schlick_fit.h"
#include "nacre/oslgen/material_program.h"
#include "nacre/pipeline/shader_tables.h"
#include "nacre/spectral/wavelength_sampling.h"
#include "technique.h"
#include "tint.h"

namespace nacre::pipeline {
namespace {

using material::GlassSpec;
using material::GratingSpec;
using material::MaterialTemplate;
using material::StackSpec;

// Those of the Abbe number beside d: ISO 7944.
constexpr double kLineF = 486.1327, kLineC = 656.2725;

// Knots of a glass: cubics between them stay within 1e-7 of any Sellmeier curve of a clear medium.
constexpr double kKnotStepNm = 10.0;
constexpr int kKnots = 48;

// Its jumps leave a kink at every cell of wavelengths: the error falls only with the step itself.
constexpr int kMostTexelsOfBands = 512;

spectral::ColourWeights colour_weights(const CompileOptions& options)
{
    const spectral::ColourSpace& space =
        options.custom_space ? *options.custom_space : spectral::colour_space(options.space);
    return spectral::reflectance_weights(spectral::named_illuminant(options.illuminant),
                                         options.observer, space, options.adaptation);
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

lut::SampledStack sampled_stack(const StackSpec& stack, bool clear_substrate, MediaReader media)
{
    lut::SampledStack result{
        .ambient = media.clear_on_grid(stack.ambient, kTraceOfK), .layers = {}, .substrate = {}};
    for (const material::LayerSpec& layer : stack.layers)
        result.layers.push_back(
            {media.on_grid(layer.medium), layer.thickness_nm.value, layer.coherent});
    result.substrate = clear_substrate ? media.clear_on_grid(stack.substrate, kTraceOfK)
                                       : media.on_grid(stack.substrate);
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
            .lowest = *std::ranges::min_element(table.texels),
            .error_unit = table.error_unit,
            .slices = table.slices,
            .sides = table.sides};
}

/// Of smooth tables. What is lost to rounding is 0.002 of ΔE00 on average, a quarter of what their
/// rows are allowed, and their files are a quarter as large.
constexpr int kTexelBits = 13;

/// R, and what light needs that goes on below the film, smooth and rough.
/// @param solid  solid_index() of a film on glass
std::vector<lut::Table> film_tables(const lut::FilmTableRequest& request, material::Interior below,
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
    if (below == material::Interior::diffuse) {
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
    if (source.parameter("coverage") == nullptr) return;
    request.stack.layers.clear();
    request.variation.reset();
    request.progress = nullptr;
    for (lut::Table& table : film_tables(request, source.interior(), solid)) {
        table.name += "_bare";
        tables.push_back(std::move(table));
    }
}

/// What the lobe of clear glass brings along, over slices as wide as those of the film.
void add_lobe_tables(double index, std::vector<lut::Table>& tables)
{
    const lut::Table& rough = *std::ranges::find(tables, "R_rough", &lut::Table::name);
    std::vector<lut::Table> lobes =
        lut::bake_lobe_tables(index, rough.x.texels / (rough.sides * rough.slices));
    std::ranges::move(lobes, std::back_inserter(tables));
}

oslgen::SchlickTerms schlick_terms(lut::SchlickFit& fit)
{
    return {.exponents = std::move(fit.exponents),
            .bare = std::move(fit.bare),
            .error_max = fit.error_max,
            .error_rms = fit.error_rms};
}

struct FilmBake {
    std::vector<lut::Table> tables;
    std::optional<oslgen::SchlickTerms> schlick;
    std::optional<double> solid_index;
};

FilmBake bake_all(const MaterialTemplate& source, const CompileOptions& options)
{
    const lut::FilmTableRequest request = film_request(source, options);
    return bake(source, [&] {
        const std::optional<double> solid = solid_index(source, options.range);
        FilmBake result{.tables = film_tables(request, source.interior(), solid),
                        .schlick = {},
                        .solid_index = solid};
        if (solid) {
            add_lobe_tables(*solid, result.tables);
        } else {
            lut::SchlickFit fit = lut::fit_schlick(request, result.tables.front());
            result.tables.push_back(std::move(fit.coefficients));
            result.schlick = schlick_terms(fit);
        }
        add_bare_tables(request, source, solid, result.tables);
        return result;
    });
}

oslgen::WavelengthTable wavelength_table(const spectral::WavelengthSampling& sampling)
{
    return {sampling.edges_nm, sampling.weight};
}

/// Colour of the metal under its cover at normal incidence, and what it does to each wavelength.
oslgen::GratingColours grating_colours(const GratingSpec& grating, MediaReader media,
                                       const spectral::ColourWeights& weights,
                                       const spectral::WavelengthSampling& sampling)
{
    const lut::IndexOnGrid cover = media.clear_on_grid(grating.cover, kTraceOfK);
    const lut::IndexOnGrid metal = media.on_grid(grating.substrate);
    media.throw_if_any();
    const double cover_index = media.constants(grating.cover)->at(kLineD).real();
    spectral::Sampled reflectance{};
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i)
        reflectance[i] = std::norm((cover[i] - metal[i]) / (cover[i] + metal[i]));
    return {.tint = weights.apply(reflectance),
            .basis = tint_basis(sampling, weights, reflectance),
            .cover_index = cover_index};
}

oslgen::GlassIndex glass_index(const GlassSpec& glass, MediaReader media,
                               const spectral::ColourWeights& weights)
{
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
    const bool light_goes_on = source.interior() != material::Interior::opaque;
    request.stack = sampled_stack(*stack, light_goes_on, {source.file, options.range});
    request.technique = technique(*stack, request.stack, source.file);
    request.variation = variation(*stack);
    request.weights = colour_weights(options);
    request.tolerance = options.tolerance;
    request.transmittance = light_goes_on;
    request.progress = options.progress;
    if (stack->technique == material::Technique::path_difference) {
        request.max_texels = kMostTexelsOfBands;
        request.accept_error = true;
    }
    return request;
}

CompiledMaterial compile(const MaterialTemplate& source, const CompileOptions& options)
{
    const bool is_film = std::holds_alternative<StackSpec>(source.kind);
    if (options.adaptation == spectral::Adaptation::none && !is_film)
        throw InputError(Diagnostic{source.file, 0, "",
                                    "must be a film where colours are not adapted (--cat none): "
                                    "glasses and gratings split white light"});
    oslgen::Context context;
    context.source = &source;
    const spectral::ColourWeights weights = colour_weights(options);
    const MediaReader media(source.file, options.range);
    context.space = weights.space;
    context.to_xyz_d65 = weights.to_xyz_d65;
    context.illuminant = weights.illuminant;
    context.observer = spectral::observer_name(weights.observer);
    context.adaptation = spectral::adaptation_name(options.adaptation);

    CompiledMaterial result{.id = source.id, .osl = {}, .manifest = {}, .tables = {}};
    if (const auto* grating = std::get_if<GratingSpec>(&source.kind)) {
        const auto sampling = spectral::sample_wavelengths(weights, kWavelengthCells);
        context.wavelengths = wavelength_table(sampling);
        context.grating = grating_colours(*grating, media, weights, sampling);
    } else if (const auto* glass = std::get_if<GlassSpec>(&source.kind)) {
        context.wavelengths =
            wavelength_table(spectral::sample_wavelengths(weights, kWavelengthCells));
        context.glass = glass_index(*glass, media, weights);
    } else {
        FilmBake baked = bake_all(source, options);
        result.tables = std::move(baked.tables);
        context.schlick = std::move(baked.schlick);
        for (const lut::Table& table : result.tables)
            context.tables.push_back(table_info(table, source.id));
        context.solid_index = baked.solid_index;
    }
    for (const spectral::HeldEnds& held : held_media(source, options))
        context.held.push_back({held.medium, held.range_nm, held.percent, held.note()});
    oslgen::MaterialProgram program = oslgen::generate(context);
    result.osl = std::move(program.osl);
    result.manifest = std::move(program.manifest);
    return result;
}

}  // namespace nacre::pipeline
