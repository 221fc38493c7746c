// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/material/head.h"
#include "nacre/oslgen/graph.h"
#include "nacre/oslgen/socket.h"
#include "nacre/oslgen/table_surface.h"

/// @file
/// A material's program, before it is written.

namespace nacre::oslgen {

/// What renderers do with an output of the node group.
enum class ClosureRole { surface, emission, volume };

[[nodiscard]] std::string_view closure_role_name(ClosureRole role);

struct Closure {
    std::string output;
    ClosureRole role = ClosureRole::surface;
};

/// What its pictures can be checked against.
enum class Truth {
    none,
    stack,  ///< R and T of the layers, as `nacre eval stack` has them
    white,  ///< it sends on all light
};

/// Empty of `none`.
[[nodiscard]] std::string_view truth_name(Truth truth);

/// What other programs may ask of a material without knowing its kind; see manifest.md.
struct Traits {
    std::string stage = "shaderball";  ///< of `render`, when none is named
    bool editable_stack = false;       ///< for the stack editor
    bool probe = false;  ///< whether a pixel can be probed for thickness, angle and spectrum
    std::vector<Closure> closures{{"BSDF", ClosureRole::surface}};
    Truth truth = Truth::none;
    bool is_body = false;  ///< light goes through it: only closed shapes show what it does
    /// Whether each path has a wavelength of its own, from OSL's `time`.
    bool wavelength_per_path = false;
};

/// A parameter of the shader that is not the artist's: its array or colour is the material's own.
struct Constant {
    std::string declaration;  ///< `float index_knots[48]`
    std::string value;        ///< as OSL
    std::string label, help;
};

/// What a shader of its own does.
struct ShaderBody {
    std::vector<std::string> includes;  ///< `nacre/nacre_disc.h`
    std::string statements;
    std::variant<Graph, std::string> nodes;  ///< the group without OSL, or why there is none
    std::optional<Graph> bands = {};         ///< the group where bands of wavelengths are rendered
};

/// A hand-written shader as it is, with its parameters.
struct ShaderText {
    std::string text;
    /// The group without OSL, and the one where bands are rendered, as in manifests.
    std::optional<nlohmann::json> nodes = {}, bands = {};
};

/// A medium that ends within the range of colours, see spectral/working_range.h.
struct HeldMedium {
    std::string medium;
    std::array<double, 2> range_nm;
    double percent;
    std::string note;
};

/// What the colours of a material are in (oslgen does not see `spectral`).
struct ColourSystem {
    std::string space, illuminant, observer, adaptation;
    std::array<std::array<double, 3>, 3> to_xyz_d65{};  ///< rows of the matrix from the space
};

struct Program {
    material::TemplateHead head;
    std::string kind;
    Traits traits;
    std::vector<Socket> sockets;  ///< in the order in which an artist sees them
    std::vector<Constant> constants;
    std::variant<TableSurface, ShaderBody, ShaderText> body;
    nlohmann::json more = nlohmann::json::object();  ///< entries of the manifest of such materials
    ColourSystem colours;
    std::vector<HeldMedium> held;
};

}  // namespace nacre::oslgen
