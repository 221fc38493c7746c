// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "../path_wavelengths.h"
#include "fields.h"
#include "nacre/kinds/media_reader.h"
#include "nacre/lut/tint_basis.h"
#include "nacre/oslgen/literals.h"

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

std::string statements(const Grating& grating, double cover_index)
{
    return fmt::format(
        "    nacre_disc_tracks disc = {{ {}, max(pitch_nm, 100.0), {}, {}, {}, {},\n"
        "                               clamp(strength, 0.0, 1.0) }};\n"
        "    BSDF = nacre_disc_lobes(disc, surface_normal, roughness, tint, wavelength_edges,\n"
        "                            wavelength_weight, tint_basis);\n",
        static_cast<int>(grating.profile), literal(grating.depth_nm), literal(grating.duty),
        literal(cover_index), grating.orders);
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
