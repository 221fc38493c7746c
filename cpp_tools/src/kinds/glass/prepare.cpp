// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/path_wavelengths.h"
#include "glass/glass.h"
#include "glass/index_curve.h"
#include "glass/sliders.h"
#include "nacre/kinds/media_reader.h"
#include "nacre/oslgen/literals.h"
#include "nacre/oslgen/shader_source.h"

namespace nacre::kinds {
namespace glass {
namespace {

using oslgen::literal;

// Those of the Abbe number beside d: ISO 7944.
constexpr double kLineF = 486.1327, kLineC = 656.2725;

// Knots of a glass: cubics between them stay within 1e-7 of any Sellmeier curve of a clear medium.
constexpr double kKnotStepNm = 10.0;
constexpr int kKnots = 48;

/// n(λ) at equally spaced knots, between which the shader draws cubics.
struct Index {
    std::vector<double> knots;
    std::array<double, 3> mean_rgb;  ///< mean of n over wavelength with the weight of each channel
    double n_F, n_d, n_C;
    IndexCurve curve;
};

Index index(const Glass& glass, MediaReader media, const spectral::ColourWeights& weights)
{
    const lut::IndexOnGrid grid = media.clear_on_grid(glass.medium, kTraceOfK);
    media.throw_if_any();
    const spectral::OpticalConstantsPtr medium = media.constants(glass.medium);
    spectral::Sampled n{};
    std::ranges::transform(grid, n.begin(), [](const auto& value) { return value.real(); });

    Index result{.knots = {},
                 .mean_rgb = weights.apply(n),
                 .n_F = medium->at(kLineF).real(),
                 .n_d = medium->at(kLineD).real(),
                 .n_C = medium->at(kLineC).real(),
                 .curve = index_curve([&](double nm) { return medium->at(nm).real(); })};
    for (int i = 0; i < kKnots; ++i)
        result.knots.push_back(medium->at(spectral::kFirstNm + i * kKnotStepNm).real());
    return result;
}

/// Those of nacre_glass, with the index from knots.
std::string statements(const Index& index)
{
    return oslgen::specialised(
        oslgen::shipped_shader("nacre_glass"),
        {.constants = {{"base", literal(index.n_d)}, {"mean_index", "index_mean"}},
         .variables = {{"index", fmt::format("nacre_index(index_knots, {}, {}, path.nm)",
                                             literal(spectral::kFirstNm), literal(kKnotStepNm))}}});
}

/// Without a wavelength per path there is no dispersion: plain glass with the index of the d line.
oslgen::Graph nodes(double n_d)
{
    oslgen::Graph graph;
    graph.node("glass", "ShaderNodeBsdfGlass", {{"distribution", "MULTI_GGX"}}, {{"IOR", n_d}});
    graph.link("input.roughness", "glass.Roughness");
    graph.link("input.normal", "glass.Normal");
    graph.link("glass.BSDF", "output.BSDF");
    return graph;
}

/// Where bands are rendered one of them at a time goes through the glass, at its own index; the
/// block sees to that, see manifest.md.
oslgen::Graph bands(double n_d, const IndexCurve& curve)
{
    oslgen::Graph graph;
    graph.node("wavelength", "nacre.wavelength");
    oslgen::Calculation calculation(graph);
    const std::string inverse =
        calculation.number("inverse", "DIVIDE", {curve.slope_nm, "wavelength.Wavelength"});
    const std::string x = calculation.number("x", "ADD", {inverse, curve.offset});
    nlohmann::json sum = curve.power.back();
    for (std::size_t k = curve.power.size() - 1; k-- > 0;)
        sum = calculation.number(fmt::format("n{}", k), "MULTIPLY_ADD", {sum, x, curve.power[k]});
    graph.node("dispersive", "nacre.dispersive_glass", {}, {{"Index", n_d}});
    graph.link(sum.get<std::string>(), "dispersive.Live Index");
    graph.link("input.dispersion", "dispersive.Dispersion");
    graph.node("glass", "ShaderNodeBsdfGlass", {{"distribution", "MULTI_GGX"}});
    graph.link("dispersive.IOR", "glass.IOR");
    for (const char* id : {"dispersive", "glass"}) {
        graph.link("input.roughness", fmt::format("{}.Roughness", id));
        graph.link("input.normal", fmt::format("{}.Normal", id));
    }
    graph.node("first", "ShaderNodeMixShader");
    graph.link("dispersive.Factor", "first.0");
    graph.link("glass.BSDF", "first.1");
    graph.link("dispersive.BSDF", "first.2");
    graph.link("first.Shader", "output.BSDF");
    return graph;
}

}  // namespace
}  // namespace glass

Prepared Glass::prepare(const MaterialTemplate& source, const CompileOptions& options) const
{
    const spectral::ColourWeights weights = options.weights();
    const glass::Index index = glass::index(*this, {source.file, options.range}, weights);

    Prepared result;
    oslgen::Program& program = result.program;
    program.sockets = {oslgen::slider_socket(glass::kDispersion), oslgen::roughness_socket(source),
                       oslgen::normal_socket()};
    program.constants = wavelength_constants(path_wavelengths(weights));
    program.constants.push_back(
        {.declaration = fmt::format("float index_knots[{}]", index.knots.size()),
         .value = oslgen::array_literal(index.knots),
         .label = "Index",
         .help = "Index over wavelength at equally spaced knots"});
    program.constants.push_back({.declaration = "color index_mean",
                                 .value = oslgen::literal(index.mean_rgb),
                                 .label = "Mean Index",
                                 .help = "Mean of the index with the weight of each channel"});
    program.body =
        oslgen::ShaderBody{.includes = {"nacre/nacre_dispersion.h", "nacre/nacre_glass.h"},
                           .statements = glass::statements(index),
                           .nodes = glass::nodes(index.n_d),
                           .bands = glass::bands(index.n_d, index.curve)};
    program.more["glass"] = {{"lines", {{"F", index.n_F}, {"d", index.n_d}, {"C", index.n_C}}},
                             {"error", index.curve.error}};
    return result;
}

}  // namespace nacre::kinds
