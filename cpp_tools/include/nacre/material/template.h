// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// @file
/// The template: the one source of a material, as the author wrote it. Media are named or described
/// here, not looked up: that needs the library and belongs to nacre/pipeline.

namespace nacre::material {

struct LibraryMedium { std::string key; };                       ///< medium = "Fe/Johnson"
struct ConstantMedium { double n, k; };                          ///< n = 1.33, k = 0.0
struct CauchyMedium { std::vector<double> coefficients; double k; };  ///< cauchy = [a, b, c], λ in µm
struct SellmeierMedium { std::vector<double> b, c; };            ///< sellmeier = { b = […], c = […] }, C in µm²
struct AbbeMedium { double n_d, v_d; };                          ///< abbe = { n_d = 1.5168, v_d = 64.17 }

/// A medium and the line of the template that names it, for messages.
struct MediumSpec {
    std::variant<LibraryMedium, ConstantMedium, CauchyMedium, SellmeierMedium, AbbeMedium> value;
    int line = 0;
};

/// A number that may be the artist's to change.
struct Quantity {
    double value = 0.0;  ///< the default
    std::optional<double> min, max;
    bool varies = false;  ///< becomes a socket and an axis of the table
    int line = 0;
};

struct LayerSpec {
    MediumSpec medium;
    Quantity thickness_nm;
    bool coherent = true;
};

/// `[stack] scale = { default, min, max }`: a factor on all coherent layers as the second axis;
/// excludes a layer that varies. `[stack] repeat` may repeat the listed group of layers.
struct StackSpec {
    MediumSpec ambient, substrate;
    std::vector<LayerSpec> layers;  ///< after `repeat` groups are unrolled; 0 … 64
    std::optional<Quantity> scale;
};

struct SurfaceSpec {
    double roughness = 0.0;
    bool transmission = false;  ///< thin-walled: what passes goes straight on; ambient = substrate
};

enum class GratingProfile { sinusoidal, rectangular, blazed };

/// `[grating]`: concentric tracks around the object's z axis.
struct GratingSpec {
    Quantity pitch_nm;
    GratingProfile profile = GratingProfile::rectangular;
    double depth_nm = 0.0;       ///< groove depth
    double duty = 0.5;
    MediumSpec cover;            ///< what fills the grooves; only its index enters the phase depth
    MediumSpec substrate;        ///< the reflecting metal
    int orders = 3;              ///< ±1 … ±orders
};

/// `[glass]`: smooth dispersive glass by a formula or a library entry.
struct GlassSpec {
    MediumSpec medium;
};

/// `[[parameter]]`: what the artist sees beyond what follows from the layers. Known names:
/// `coverage` (fades the film), `roughness`, `tint`… unknown names are errors that list these.
struct ParameterSpec {
    std::string name, label, description;
    double value = 0.0, min = 0.0, max = 1.0;
    int line = 0;
};

struct MaterialTemplate {
    std::string id, name, category, description, source;
    std::variant<StackSpec, GratingSpec, GlassSpec> kind;
    SurfaceSpec surface;
    std::vector<ParameterSpec> parameters;
    std::string file;    ///< for messages
    std::string sha256;  ///< of the template's bytes
};

/// @param file  what to call the input in messages
/// @throws InputError with every problem of the file, each with its line.
[[nodiscard]] MaterialTemplate parse_template(std::string_view toml, std::string_view file);

/// JSON Schema (draft 2020-12) of the format, for editors; `nacre library schema` prints it.
[[nodiscard]] std::string template_json_schema();

}  // namespace nacre::material
