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
    std::string type;   ///< `float`, `int`, `color`, `normal`
    std::string unit;   ///< `nm`, `1`, …
    std::string description;
    double value = 0.0, min = 0.0, max = 1.0;  ///< of float and int
};

/// What the generator must know of a table that the pipeline bakes.
struct TableInfo {
    std::string name, file, quantity;
    struct Axis {
        std::string name, unit;
        double min, max;
        int texels;
    } x, y;
    double error_max, error_mean;
};

/// λ(u) and its weights, see spectral/wavelength_sampling.h (oslgen does not see that module).
struct WavelengthTable {
    std::vector<double> edges_nm;
    std::vector<std::array<double, 3>> weight;
};

/// All that the pipeline found out about a template.
struct Context {
    const material::MaterialTemplate* source = nullptr;
    std::vector<TableInfo> tables;  ///< of films
    std::optional<WavelengthTable> wavelengths;      ///< of gratings and glasses
    std::vector<double> index_edges_nm, index_n;     ///< of glasses: n(λ) at knots, or a formula
    std::string space, illuminant, observer;
    double substrate_reflectance[3] = {1, 1, 1};     ///< of gratings: RGB of the metal under the cover
    double cover_index = 1.0;                        ///< of gratings
};

/// The material's program: everything but the tables' texels.
struct MaterialProgram {
    std::string osl;       ///< one file, includes inlined
    std::string manifest;  ///< JSON, ends with a newline; form: cpp_tools/doc/manifest.md
};

[[nodiscard]] MaterialProgram generate(const Context& context);

/// Replaces `#include "nacre/…"` by the embedded header's text, each header once.
/// @throws InputError for a header that is not there.
[[nodiscard]] std::string inline_includes(const std::string& osl, const std::string& name);

}  // namespace nacre::oslgen
