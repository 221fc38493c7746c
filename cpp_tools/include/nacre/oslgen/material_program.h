// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "nacre/material/template.h"

/// @file
/// From a template to shader text and manifest.

namespace nacre::oslgen {

/// An input that the artist sees: an OSL parameter, a socket of the node group, a `--set` name.
struct Socket {
    std::string name;   ///< lives in saved files: never rename one
    std::string label;  ///< with the unit in it: `Thickness (nm)`
    std::string type;   ///< `float`, `int`, `color`, `normal`, `tangent`
    std::string unit;   ///< `nm`, `1`, …
    std::string description;
    double value = 0.0, min = 0.0, max = 1.0;     ///< of float and int
    std::array<double, 3> colour{1.0, 1.0, 1.0};  ///< default of color
};

/// What the generator must know of a table that the pipeline bakes.
struct TableInfo {
    std::string name, file, quantity;
    struct Axis {
        std::string name, unit;
        double min, max;
        int texels;
    };
    Axis x, y;
    double error_max, error_mean;
    double lowest;  ///< of all texels and channels; below 0 where a colour is out of the gamut
    std::string error_unit = "dE00";
    int slices = 1;  ///< of roughness, side by side along x: see lut/rough_tables.h
    int sides = 1;   ///< of glass: so many times all slices, see lut/rough_glass_tables.h
};

/// λ(u) and its weights, see spectral/wavelength_sampling.h (oslgen does not see that module).
struct WavelengthTable {
    std::vector<double> edges_nm;
    std::vector<std::array<double, 3>> weight;
};

/// n(λ) of a glass at equally spaced knots, between which the shader draws cubics.
struct GlassIndex {
    double first_nm, step_nm;
    std::vector<double> knots;
    std::array<double, 3> mean_rgb;  ///< mean of n over wavelength with the weight of each channel
    double n_F, n_d, n_C;
};

/// Reflectance as a sum of powers over the facet's cosine, see lut/schlick_fit.h; the coefficients
/// of the film are in the table `R_schlick`.
struct SchlickTerms {
    std::vector<double> exponents;
    std::vector<std::array<double, 3>> bare;  ///< coefficients without a film
    double error_max, error_rms;
};

/// What the shader of a grating needs beyond the template.
struct GratingColours {
    std::array<double, 3> tint;  ///< reflectance of the metal under its cover
    /// For each cell of wavelengths: tint · basis is what is left of its light (lut/tint_basis.h).
    std::vector<std::array<double, 3>> basis;
    double cover_index;  ///< at the d line
};

/// A medium that ends within the range of colours, see spectral/working_range.h.
struct HeldMedium {
    std::string medium;
    std::array<double, 2> range_nm;
    double percent;
    std::string note;
};

/// All that the pipeline found out about a template.
struct Context {
    const material::MaterialTemplate* source = nullptr;
    std::vector<TableInfo> tables;               ///< of films
    std::optional<WavelengthTable> wavelengths;  ///< of gratings and glasses
    std::optional<GlassIndex> glass;
    std::optional<GratingColours> grating;
    std::optional<SchlickTerms> schlick;  ///< of films whose lobe is not that of clear glass
    std::optional<double> solid_index;    ///< of a film on clear glass: relative, at the d line
    std::vector<HeldMedium> held;
    std::string space, illuminant, observer, adaptation;
    /// Of the space: rows of the matrix from its colours to XYZ (oslgen does not see `spectral`).
    std::array<std::array<double, 3>, 3> to_xyz_d65{};
};

/// The material's program: everything but the tables' texels.
struct MaterialProgram {
    std::string osl;       ///< one file, includes inlined
    std::string manifest;  ///< JSON, ends with a newline; form: cpp_tools/doc/manifest.md
};

[[nodiscard]] MaterialProgram generate(const Context& context);

/// In the order in which an artist sees them.
[[nodiscard]] std::vector<Socket> sockets(const Context& context);

/// Replaces `#include "nacre/…"` by the embedded header's text, each header once.
/// @throws InputError for a header that is not there.
[[nodiscard]] std::string inline_includes(const std::string& osl, const std::string& name);

}  // namespace nacre::oslgen
