// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "grating/grating.h"

namespace nacre::kinds::grating {

using material::field, material::Slider, material::SliderInfo;

inline constexpr auto kPitch = field<&Grating::pitch_nm>({.key = "pitch_nm",
                                                          .label = "Pitch",
                                                          .help = "Distance of neighbouring tracks",
                                                          .unit = "nm",
                                                          .bounds = {100.0, 1e6},
                                                          .required = true,
                                                          .slider = Slider::always});

inline constexpr auto kDepth = field<&Grating::depth_nm>({.key = "depth_nm",
                                                          .help = "groove depth",
                                                          .unit = "nm",
                                                          .bounds = {0.0, 1e5},
                                                          .required = true});

inline constexpr auto kOrders = field<&Grating::orders>(
    {.key = "orders", .help = "highest order to either side", .bounds = {1.0, 9.0}});

inline constexpr std::array kFields{
    kPitch,
    kDepth,
    field<&Grating::profile>({.key = "profile",
                              .help = "of a groove",
                              .required = true,
                              .choices = optics::kProfileNames}),
    field<&Grating::duty>(
        {.key = "duty", .help = "raised share of the period", .bounds = {0.0, 1.0}},
        [](const Grating& grating) { return grating.profile == optics::ProfileKind::rectangular; }),
    kOrders,
    field<&Grating::cover>({.key = "cover", .required = true, .is_clear = true}),
    field<&Grating::substrate>({.key = "substrate", .required = true}),
};

inline constexpr SliderInfo kStrength{
    .name = "strength",
    .label = "Strength",
    .help = "Share of the diffracted light; the rest stays in the mirror image",
    .value = 1.0};

}  // namespace nacre::kinds::grating
