// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/kinds/kind.h"
#include "nacre/lut/film_request.h"
#include "nacre/material/fields.h"
#include "nacre/optics/film_stack.h"

/// @file
/// Films: stacks of layers in which light interferes.

namespace nacre::kinds {

using optics::kMaxLayers;

struct LayerSpec {
    material::MediumSpec medium;
    material::Quantity thickness_nm;
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

/// What a film lies on, as the light finds it.
enum class Interior {
    opaque,     ///< nothing comes back from below
    thin_wall,  ///< what passes goes straight on: ambient and substrate are one medium
    solid,      ///< clear: what passes is refracted, and meets the film again from inside
    diffuse,    ///< clear and thin over a matt base
};

/// `[[layer]]` is one layer, or a group `{ repeat = 7, group = [{…}, {…}] }`.
/// `[stack] scale = { default, min, max }`: a factor on all coherent layers as the second axis;
/// excludes a layer that varies. `[stack] technique = "…"`: what the reflectance is computed by.
class Film final : public Kind {
public:
    static constexpr std::string_view kName = "film";

    material::MediumSpec ambient, substrate;
    std::vector<LayerSpec> layers;  ///< with groups unrolled; 0 … kMaxLayers
    std::optional<material::Quantity> scale;
    Technique technique = Technique::multilayer;
    int technique_line = 0;
    /// Of brushed surfaces, −0.9…0.9 as Blender's Glossy has it; none: the surface has no direction
    std::optional<double> anisotropy;
    bool transmission = false;  ///< light passes through the film
    /// Reflectance of a matt base under a clear substrate, each channel 0…1: the artist's colour
    std::optional<std::array<double, 3>> diffuse_base;

    /// Index of the layer that varies.
    [[nodiscard]] std::optional<std::size_t> varying_layer() const;
    [[nodiscard]] Interior interior() const;

    [[nodiscard]] std::string_view name() const override { return kName; }
    [[nodiscard]] oslgen::Traits traits() const override;
    [[nodiscard]] std::vector<const material::MediumSpec*> media() const override;
    [[nodiscard]] std::string driven_socket() const override;
    [[nodiscard]] Prepared prepare(const MaterialTemplate& source,
                                   const CompileOptions& options) const override;
    void check(const MaterialTemplate& source, const CompileOptions& options) const override;
    [[nodiscard]] std::variant<MaterialTemplate, std::string> exported(
        const MaterialTemplate& source) const override;
};

/// @param problem  what to say of other kinds
/// @throws InputError where the template is not a film's
[[nodiscard]] const Film& film_of(
    const MaterialTemplate& source,
    std::string_view problem = "must be a film: [ambient], [[layer]], [substrate]");

/// The same material with another film.
[[nodiscard]] MaterialTemplate with_film(MaterialTemplate source, Film film);

/// The bare substrate of a film.
[[nodiscard]] MaterialTemplate without_layers(const MaterialTemplate& source);

/// The stack of a film template with media looked up; what `bake stack` and tests use.
/// Every wavelength-dependent index is on the 1 nm grid.
[[nodiscard]] lut::FilmTableRequest film_request(const MaterialTemplate& source,
                                                 const CompileOptions& options);

}  // namespace nacre::kinds
