// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "nacre/spectral/colour.h"

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

/// @file
/// The space that colours are written in: built in, or a space or role of an OpenColorIO config.

namespace nacre::tool {

struct ColourTargetOptions {
    std::string config;  ///< file or URI; empty: the built-in spaces
    std::string space;   ///< empty: lin_rec709_scene, or the config's role `scene_linear`
};

struct ColourTarget {
    std::string name;
    /// From XYZ relative to D65; not a matrix where the space is not scene-linear.
    std::function<spectral::Vec3(const spectral::Vec3& xyz_d65)> from_xyz_d65;
    /// Absent where the space is not a matrix away from XYZ.
    std::optional<spectral::ColourSpace> linear;
    bool built_in = true;
};

using spectral::multiply;

void add_colour_target_options(CLI::App& command, ColourTargetOptions& options);

/// @throws InputError for an unknown space, or a config that cannot be read; never falls back.
[[nodiscard]] ColourTarget resolve_colour_target(const ColourTargetOptions& options);

/// For tables, whose texels a renderer interpolates and multiplies.
/// @throws InputError when the space is not scene-linear.
[[nodiscard]] spectral::ColourSpace linear_space(const ColourTarget& target);

/// `--cat`: how the white of a light becomes that of the space.
void add_adaptation_option(CLI::App& command, std::string& name);
/// For spectral::adaptation(), whose user has that option.
inline constexpr std::string_view kWithoutCat = "; --cat none takes it as it is";

}  // namespace nacre::tool
