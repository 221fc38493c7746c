// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colour/target.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "colour/config.h"
#include "nacre/core/diagnostics.h"

namespace nacre::tool {
namespace {

using spectral::determinant;
using spectral::inverse;
using spectral::Mat3;
using spectral::Vec3;

std::array<double, 8> chromaticities(const Mat3& to_xyz)
{
    std::array<double, 8> xy{};
    const auto set = [&xy](std::size_t at, const Vec3& xyz) {
        const double sum = xyz[0] + xyz[1] + xyz[2];
        xy[at] = xyz[0] / sum;
        xy[at + 1] = xyz[1] / sum;
    };
    for (std::size_t primary = 0; primary < 3; ++primary)
        set(2 * primary, {to_xyz[0][primary], to_xyz[1][primary], to_xyz[2][primary]});
    set(6, multiply(to_xyz, Vec3{1.0, 1.0, 1.0}));
    return xy;
}

/// @throws InputError for a space that has no way from XYZ
std::function<Vec3(const Vec3&)> conversion(const std::string& file, const std::string& name)
{
    ConfigSpace space = read_config_space(file, name);
    if (!space.is_known)
        throw InputError({file, 0, "--space",
                          fmt::format("must be a space or role of the config: {} (got {})",
                                      fmt::join(space.names, ", "), name)});
    if (space.is_data)
        throw InputError(
            {file, 0, "--space", fmt::format("must be a space of colours; {} holds data", name)});
    if (!space.has_interchange)
        throw InputError({file, 0, "roles",
                          fmt::format("must have {}, through which XYZ enters", kInterchangeRole)});
    if (!space.failure.empty())
        throw InputError({file, 0, "--space", fmt::format("{}: {}", name, space.failure)});
    return space.from_xyz_d65;
}

/// The matrix of a conversion, or nothing where it is not one: negative, dark and bright colours,
/// which a curve would bend, come out as the matrix says.
std::optional<Mat3> matrix_of(const std::function<Vec3(const Vec3&)>& convert)
{
    Mat3 matrix{};
    for (std::size_t column = 0; column < 3; ++column) {
        Vec3 unit{};
        unit[column] = 1.0;
        const Vec3 image = convert(unit);
        for (std::size_t row = 0; row < 3; ++row) matrix[row][column] = image[row];
    }
    for (const Vec3& probe :
         {Vec3{0, 0, 0}, {0.18, 0.2, 0.1}, {-0.3, 0.1, 0.4}, {40.0, 20.0, 70.0}}) {
        const Vec3 expected = multiply(matrix, probe), actual = convert(probe);
        const double scale = std::abs(probe[0]) + std::abs(probe[1]) + std::abs(probe[2]);
        for (std::size_t i = 0; i < 3; ++i)
            if (!(std::abs(actual[i] - expected[i]) <= 1e-5 * scale)) return std::nullopt;
    }
    return std::abs(determinant(matrix)) > 1e-9 ? std::optional(matrix) : std::nullopt;
}

ColourTarget config_target(const std::string& file, const std::string& name)
{
    ColourTarget target{name, conversion(file, name), std::nullopt, false};
    if (const auto matrix = matrix_of(target.from_xyz_d65)) {
        // As in tables; and a batch need not ask another process for each of its colours.
        target.from_xyz_d65 = [m = *matrix](const Vec3& xyz) { return multiply(m, xyz); };
        const Mat3 to_xyz = inverse(*matrix);
        target.linear = {name, *matrix, to_xyz, chromaticities(to_xyz)};
    }
    return target;
}

}  // namespace

void add_colour_target_options(CLI::App& command, ColourTargetOptions& options)
{
    command
        .add_option("--space", options.space,
                    fmt::format("{}; with --config any space or role of it (default: "
                                "lin_rec709_scene, with --config its role scene_linear)",
                                fmt::join(spectral::colour_space_names(), ", ")))
        ->type_name("NAME");
    command
        .add_option("--config", options.config,
                    "OpenColorIO config that defines --space, or a URI such as ocio://default")
        ->type_name("FILE");
}

ColourTarget resolve_colour_target(const ColourTargetOptions& options)
{
    if (!options.config.empty())
        return config_target(options.config,
                             options.space.empty() ? "scene_linear" : options.space);
    const spectral::ColourSpace& space =
        spectral::colour_space(options.space.empty() ? "lin_rec709_scene" : options.space);
    return {space.name, [&space](const Vec3& xyz) { return multiply(space.from_xyz_d65, xyz); },
            space, true};
}

spectral::ColourSpace linear_space(const ColourTarget& target)
{
    if (target.linear) return *target.linear;
    throw InputError({"", 0, "--space",
                      fmt::format("must be scene-linear, because renderers interpolate a table's "
                                  "texels; {} is not",
                                  target.name)});
}

void add_adaptation_option(CLI::App& command, std::string& name)
{
    command
        .add_option("--cat", name,
                    "adaptation of the illuminant's white to D65: bradford, cat16; none: colours "
                    "have the light in them")
        ->check(CLI::IsMember({"bradford", "cat16", "none"}))
        ->capture_default_str();
}

}  // namespace nacre::tool
