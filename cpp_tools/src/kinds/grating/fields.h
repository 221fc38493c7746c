// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "grating/grating.h"

namespace nacre::kinds::grating {

using material::field, material::Slider, material::SliderInfo;

/// In the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kProfiles{"sinusoidal", "rectangular", "blazed"};

inline constexpr auto kPitch = field<&Grating::pitch_nm>({.key = "pitch_nm",
                                                          .label = "Pitch",
                                                          .help = "Distance of neighbouring tracks",
                                                          .unit = "nm",
                                                          .bounds = {100.0, 1e6},
                                                          .required = true,
                                                          .slider = Slider::always});

inline constexpr std::array kFields{
    kPitch,
    field<&Grating::depth_nm>({.key = "depth_nm",
                               .help = "groove depth",
                               .unit = "nm",
                               .bounds = {0.0, 1e5},
                               .required = true}),
    field<&Grating::profile>(
        {.key = "profile", .help = "of a groove", .required = true, .choices = kProfiles}),
    field<&Grating::duty>(
        {.key = "duty", .help = "raised share of the period", .bounds = {0.0, 1.0}},
        [](const Grating& grating) { return grating.profile == GratingProfile::rectangular; }),
    field<&Grating::orders>(
        {.key = "orders", .help = "highest order to either side", .bounds = {1.0, 9.0}}),
    field<&Grating::cover>({.key = "cover", .required = true, .is_clear = true}),
    field<&Grating::substrate>({.key = "substrate", .required = true}),
};

inline constexpr SliderInfo kStrength{
    .name = "strength",
    .label = "Strength",
    .help = "Share of the diffracted light; the rest stays in the mirror image",
    .value = 1.0};

}  // namespace nacre::kinds::grating
