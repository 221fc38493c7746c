// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "nacre/lut/table.h"

/// @file
/// How tables hold colours over roughness.

namespace nacre::lut {

/// Roughness (GGX alpha is its square) of the slices of a rough table: 1/n, 2/n … 1, side by side
/// along x, each over cos_theta from 0 to 1. The smooth table is the slice of roughness 0. Within a
/// slice a shader interpolates linearly, between two by slice_share().
inline constexpr int kRoughSlices = 10;

/// Of the texels of rough tables, see rounded_texel(): a tenth of what they are off by between
/// texels.
inline constexpr int kRoughTexelBits = 9;

/// Share of slice `low` + 1, the rest being that of slice `low`, in what is read between them at
/// `slice` = roughness × kRoughSlices: linear in alpha², as means over facets and the albedo of a
/// lobe are for small alpha. Linear in the roughness, tint times albedo of a surface that keeps all
/// light would be up to 1.011.
[[nodiscard]] double slice_share(double slice, int low) noexcept;

/// Tints of a lobe whose single-scattering albedo E(θ, α) the renderer brings along.
struct RoughTables {
    /// `R_rough`: the mean over the facets that a view sees, weighted by the light that gets out,
    /// and what leaves after two and more bounces, divided by E.
    Table reflectance;
    /// `T_rough`: the mean over the facets and what other facets pass of the light that the first
    /// ones reflected, so that a clear wall keeps all light: E R + T = 1.
    std::optional<Table> transmittance;
    /// `R_further`: what leaves after two and more bounces alone, divided by E; each wavelength by
    /// itself, as walk_microsurface() finds it. Not of films on solid glass.
    std::optional<Table> further;
};

}  // namespace nacre::lut
