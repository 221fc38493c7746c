// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "nacre/kinds/film.h"
#include "nacre/material/fields.h"

namespace nacre::kinds::film {

using material::field, material::Slider, material::SliderInfo;

inline constexpr double kMaxThicknessNm = 1e8;  // 10 cm: a larger number of nm is a slip

inline constexpr auto kThickness = field<&LayerSpec::thickness_nm>(
    {.key = "thickness_nm",
     .label = "Film Thickness",
     .help = "Thickness of the film, held to the range of the table",
     .unit = "nm",
     .bounds = {0.0, kMaxThicknessNm},
     .required = true,
     .slider = Slider::may});
inline constexpr std::array kLayerFields{
    kThickness,
    field<&LayerSpec::coherent>({.key = "coherent", .help = "false: fringes average out"}),
};

inline constexpr auto kScale = field<&Film::scale>(
    {.key = "scale",
     .label = "Film Thickness (×)",
     .help = "Factor on the thickness of every layer, held to the range of the table; moves all "
             "colours",
     .bounds = {0.0, 100.0},
     .slider = Slider::always});

inline constexpr auto kAnisotropy = field<&Film::anisotropy>(
    {.key = "anisotropy",
     .label = "Anisotropy",
     .help = "0: no direction; above 0 highlights are drawn out across the tangent",
     .bounds = {-0.9, 0.9}});

inline constexpr auto kDiffuseBase =
    field<&Film::diffuse_base>({.key = "diffuse_base",
                                .label = "Base Colour",
                                .help = "Colour of the matt base under the film and its substrate",
                                .bounds = {0.0, 1.0}});

inline constexpr std::array kSurfaceFields{
    kAnisotropy,
    field<&Film::transmission>({.key = "transmission", .help = "light passes through the film"}),
    kDiffuseBase,
};

inline constexpr SliderInfo kCoverage{.name = "coverage",
                                      .label = "Coverage",
                                      .help = "0: bare substrate, 1: film",
                                      .value = 1.0,
                                      .is_declared = true};

}  // namespace nacre::kinds::film
