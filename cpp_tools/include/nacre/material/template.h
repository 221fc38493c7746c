// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// @file
/// The template: the one source of a material, as the author wrote it. Media are named or described
/// here, not looked up: that needs the library and belongs to nacre/pipeline.

namespace nacre::material {

/// medium = "Fe/Johnson"
struct LibraryMedium {
    std::string key;
    bool operator==(const LibraryMedium&) const = default;
};

/// n = 1.33, k = 0.0
struct ConstantMedium {
    double n = 1.0, k = 0.0;
    bool operator==(const ConstantMedium&) const = default;
};

/// cauchy = [a, b, c], λ in µm; one to three coefficients
struct CauchyMedium {
    std::vector<double> coefficients;
    double k = 0.0;
    bool operator==(const CauchyMedium&) const = default;
};

/// sellmeier = { b = […], c = […] }, C in µm²
struct SellmeierMedium {
    std::vector<double> b, c;
    bool operator==(const SellmeierMedium&) const = default;
};

/// abbe = { n_d = 1.5168, v_d = 64.17 }
struct AbbeMedium {
    double n_d = 1.5, v_d = 60.0;
    bool operator==(const AbbeMedium&) const = default;
};

/// A medium, and where the template names it, for messages.
struct MediumSpec {
    std::variant<LibraryMedium, ConstantMedium, CauchyMedium, SellmeierMedium, AbbeMedium> value;
    int line = 0;
    std::string field;  ///< e.g. `layer[2].medium`
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

/// What the reflectance of a film is computed by: the multilayer, or a closed form of
/// nacre/optics/film_models.h of that name, for comparison.
enum class Technique {
    multilayer,
    path_difference,
    airy,
    series,
    opaque_base,
    free_film,
    etalon,
    recursion,
};

/// In the order of the enumeration.
[[nodiscard]] std::span<const std::string_view> technique_names();
[[nodiscard]] std::string_view technique_name(Technique technique);

/// `[[layer]]` is one layer, or a group `{ repeat = 7, group = [{…}, {…}] }`.
/// `[stack] scale = { default, min, max }`: a factor on all coherent layers as the second axis;
/// excludes a layer that varies. `[stack] technique = "…"`: what the reflectance is computed by.
struct StackSpec {
    MediumSpec ambient, substrate;
    std::vector<LayerSpec> layers;  ///< with groups unrolled; 0 … kMaxLayers
    std::optional<Quantity> scale;
    Technique technique = Technique::multilayer;
    int technique_line = 0;

    /// Index of the layer that varies.
    [[nodiscard]] std::optional<std::size_t> varying_layer() const;
};

inline constexpr int kMaxLayers = 64;

struct SurfaceSpec {
    double roughness = 0.0;
    /// Of brushed surfaces, −0.9…0.9 as Blender's Glossy has it; none: the surface has no direction
    std::optional<double> anisotropy;
    bool transmission = false;  ///< light passes through the film
    /// Reflectance of a matt base under a clear substrate, each channel 0…1: the artist's colour
    std::optional<std::array<double, 3>> diffuse_base;
};

/// What a film lies on, as the light finds it.
enum class Interior {
    opaque,     ///< nothing comes back from below
    thin_wall,  ///< what passes goes straight on: ambient and substrate are one medium
    solid,      ///< clear: what passes is refracted, and meets the film again from inside
    diffuse,    ///< clear and thin over a matt base
};

enum class GratingProfile { sinusoidal, rectangular, blazed };

/// `[grating]`: concentric tracks around the object's z axis.
struct GratingSpec {
    Quantity pitch_nm;
    GratingProfile profile = GratingProfile::rectangular;
    double depth_nm = 0.0;  ///< groove depth
    double duty = 0.5;      ///< fraction of the period that is raised; rectangular only
    MediumSpec cover;       ///< what fills the grooves; only its index enters the phase depth
    MediumSpec substrate;   ///< the reflecting metal
    int orders = 3;         ///< ±1 … ±orders
};

/// `[glass]`: smooth dispersive glass by a formula or a library entry.
struct GlassSpec {
    MediumSpec medium;
};

/// `[[parameter]]`: a slider beyond what follows from the layers, or another label, range or
/// default for one that every material of the kind has.
///   film     `coverage` (fades to the bare substrate; only where declared), `roughness`
///   grating  `strength`, `roughness`
///   glass    `dispersion`, `roughness`
struct ParameterSpec {
    std::string name, label, description;
    double value = 0.0, min = 0.0, max = 1.0;
    int line = 0;
};

/// How far the values of a material can be trusted.
enum class Status {
    measured,  ///< the stack was measured on one specimen, and so were its media
    sourced,   ///< each value has a source
    typical,   ///< some values are only of the right size
};

[[nodiscard]] std::string_view status_name(Status status);

/// How the material looks its best. The library does not read it: who makes pictures does.
struct LookSpec {
    std::string object;                  ///< what it is pictured on, such as `blade`; may be empty
    std::vector<std::string> thickness;  ///< sources of a thickness, `SOURCE[:NAME=VALUE,…]`

    bool operator==(const LookSpec&) const = default;
};

struct MaterialTemplate {
    std::string id, name, category, description, source;
    Status status = Status::typical;
    std::vector<std::string> tags;  ///< for searches
    std::variant<StackSpec, GratingSpec, GlassSpec> kind;
    SurfaceSpec surface;
    std::vector<ParameterSpec> parameters;
    LookSpec look;

    [[nodiscard]] const ParameterSpec* parameter(std::string_view parameter_name) const;
    /// All that it is made of, from the ambient or the cover down.
    [[nodiscard]] std::vector<const MediumSpec*> media() const;
    /// Of a film; of other kinds it means nothing.
    [[nodiscard]] Interior interior() const;

    std::string file;    ///< for messages
    std::string text;    ///< the template's bytes
    std::string sha256;  ///< of them
};

/// @param file  what to call the input in messages
/// @throws InputError with every problem of the file, each with its line.
[[nodiscard]] MaterialTemplate parse_template(std::string_view toml, std::string_view file);

/// JSON Schema (draft 2020-12) of the format, for editors; `nacre library schema` prints it.
[[nodiscard]] std::string template_json_schema();

}  // namespace nacre::material
