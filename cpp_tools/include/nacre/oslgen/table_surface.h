// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/core/table_role.h"

/// @file
/// The program of a surface whose colours are read from tables over the angle of view and one
/// number more. Two writers put it down, as OSL and as nodes; what there is to decide is decided
/// here.

namespace nacre::oslgen {

/// What the writers must know of a table.
struct TableInfo {
    TableRole role;
    std::string file, quantity;
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

    [[nodiscard]] const std::string& name() const { return table_name(role); }
};

/// A colour of one substrate, with its film or without.
struct TableColour {
    TableInfo smooth;
    std::optional<TableInfo> rough;  ///< of the same quantity over roughness
    /// Of brushed surfaces, which see it at a roughness of its own: what `rough` has of it is taken
    /// away.
    std::optional<TableInfo> further;
};

/// A colour that fades to the bare substrate's by the coverage, where there is one.
struct FadedColour {
    TableColour film;
    std::optional<TableColour> bare;
};

/// Nothing comes back from below.
struct OpaqueBase {};

/// What passes goes straight on.
struct ThinWall {};

/// What passes is refracted, and meets the surface again from inside.
struct SolidGlass {
    double index;  ///< relative, at the d line
};

/// A matt base of the colour `base_colour` under it.
struct MattBase {};

/// Reflectance as a sum of powers over the facet's cosine, see lut/schlick_fit.h. In OSL alone.
struct PowerLobes {
    std::vector<double> exponents;
    std::vector<std::array<double, 3>> bare;  ///< coefficients without a film
    double error_max, error_rms;              ///< of the sum
};

struct TableSurface {
    std::vector<TableInfo> tables;  ///< R at least
    std::variant<OpaqueBase, ThinWall, SolidGlass, MattBase> below;
    bool is_brushed = false;  ///< with the sockets `anisotropy`, `rotation` and `tangent`
    bool fades = false;       ///< to the bare substrate, by the socket `coverage`
    std::optional<PowerLobes> powers{};

    /// Table of this role, or nothing.
    [[nodiscard]] const TableInfo* find(const TableRole& role) const;
    /// @pre there is a smooth table of it
    [[nodiscard]] TableColour colour(TableOf of, bool is_bare = false) const;
    [[nodiscard]] FadedColour faded(TableOf of) const;
    /// What leaves after two and more bounces, with its film and without; nothing where there is
    /// none.
    [[nodiscard]] std::vector<TableInfo> further_bounces() const;
    /// Coefficients of the powers of the bare substrate where the coverage fades to it; else none.
    [[nodiscard]] std::vector<std::array<double, 3>> bare_powers() const;
    /// The second axis, where something varies.
    [[nodiscard]] std::optional<TableInfo::Axis> row() const;
    /// Relative index of solid glass.
    [[nodiscard]] std::optional<double> solid_index() const;
    /// Whether R is outside the gamut somewhere: a renderer that cuts negative channels there sends
    /// too much on, which what passes has to make good.
    [[nodiscard]] bool has_negative() const;
};

/// Whether the node graph may look the table's colour up for the shader: all but the rough ones,
/// which are mixed into the smooth.
[[nodiscard]] bool is_looked_up(const TableInfo& table);

}  // namespace nacre::oslgen
