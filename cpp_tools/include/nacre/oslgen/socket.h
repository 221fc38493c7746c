// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>

#include "nacre/material/fields.h"
#include "nacre/material/head.h"

/// @file
/// Inputs that the artist sees.

namespace nacre::oslgen {

/// An OSL parameter, a socket of the node group, a `--set` name.
struct Socket {
    std::string name;   ///< lives in saved files: never rename one
    std::string label;  ///< with the unit in it: `Thickness (nm)`
    std::string type;   ///< `float`, `int`, `color`, `normal`, `tangent`
    std::string unit;   ///< `nm`, `1`, …
    std::string description;
    double value = 0.0, min = 0.0, max = 1.0;     ///< of float and int
    std::array<double, 3> colour{1.0, 1.0, 1.0};  ///< default of color
};

/// `normal` is a keyword of OSL, so the parameter of that socket has another name.
[[nodiscard]] std::string parameter_name(const Socket& socket);

/// Of a field that is the artist's to change; without a range, from half to twice its value.
[[nodiscard]] Socket slider_socket(const material::FieldInfo& info,
                                   const material::Quantity& quantity);
[[nodiscard]] Socket slider_socket(const material::SliderInfo& info);
[[nodiscard]] Socket colour_socket(std::string name, std::string label, std::string description,
                                   const std::array<double, 3>& colour);
/// For bump and normal maps.
[[nodiscard]] Socket normal_socket();

/// The roughness, which all materials have.
[[nodiscard]] Socket roughness_socket(const material::TemplateHead& head);

/// What the template's `[[parameter]]` say wins.
void apply_parameters(const material::TemplateHead& head, std::span<Socket> sockets);

}  // namespace nacre::oslgen
