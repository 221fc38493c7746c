// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/path_wavelengths.h"
#include "grating/fields.h"
#include "nacre/kinds/media_reader.h"
#include "nacre/lut/tint_basis.h"
#include "nacre/oslgen/literals.h"
#include "nacre/oslgen/shader_source.h"

namespace nacre::kinds {
namespace grating {
namespace {

using oslgen::literal;

/// Colour of the metal under its cover at normal incidence, and what it does to each wavelength.
struct Colours {
    std::array<double, 3> tint;
    /// For each cell of wavelengths: tint · basis is what is left of its light (lut/tint_basis.h).
    std::vector<std::array<double, 3>> basis;
    double cover_index;  ///< at the d line
};

Colours colours(const Grating& grating, MediaReader media, const spectral::ColourWeights& weights,
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
            .basis = lut::tint_basis(sampling, weights, reflectance),
            .cover_index = cover_index};
}

/// Those of nacre_disc, at what the template fixes.
std::string statements(const Grating& grating, double cover_index)
{
    return oslgen::specialised(
        oslgen::shipped_shader("nacre_disc"),
        {.constants = {{"profile", std::to_string(static_cast<int>(grating.profile))},
                       {"depth_nm", literal(grating.depth_nm)},
                       {"duty", literal(grating.duty)},
                       {"cover_index", literal(cover_index)},
                       {"orders", std::to_string(grating.orders)}},
         .variables = {}});
}

}  // namespace
}  // namespace grating

Prepared Grating::prepare(const MaterialTemplate& source, const CompileOptions& options) const
{
    const spectral::ColourWeights weights = options.weights();
    const spectral::WavelengthSampling sampling = path_wavelengths(weights);
    const grating::Colours colours =
        grating::colours(*this, {source.file, options.range}, weights, sampling);

    Prepared result;
    oslgen::Program& program = result.program;
    program.sockets = {
        oslgen::slider_socket(grating::kPitch.info, pitch_nm),
        oslgen::colour_socket("tint", "Tint", "Colour of the reflecting metal", colours.tint),
        oslgen::slider_socket(grating::kStrength), oslgen::roughness_socket(source),
        oslgen::normal_socket()};
    program.constants = wavelength_constants(sampling);
    program.constants.push_back(
        {.declaration = fmt::format("color tint_basis[{}]", colours.basis.size()),
         .value = oslgen::array_literal(colours.basis),
         .label = "Tint Basis",
         .help = "What the metal leaves of each cell, by its colour"});
    program.body = oslgen::ShaderBody{
        .includes = {"nacre/nacre_disc.h"},
        .statements = grating::statements(*this, colours.cover_index),
        .nodes = "each path has a wavelength of its own, which nodes cannot draw"};
    program.more["grating"] = {{"pitch_nm", pitch_nm.value}, {"orders", orders}};
    return result;
}

}  // namespace nacre::kinds
