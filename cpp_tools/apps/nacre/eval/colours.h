// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "colour/target.h"
#include "eval/records.h"
#include "nacre/media/working_range.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/gamut.h"

/// @file
/// The records of `nacre eval` that are answered by colours.

namespace nacre::tool {

/// How spectra come to XYZ, and from there to rgb.
struct ColourChoices {
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    spectral::GamutMapping gamut = spectral::GamutMapping::keep;
    std::string sampling = "adaptive";                           ///< see spectral::named_quadrature
    spectral::RangeRule range = spectral::RangeRule::hold_ends;  ///< of media
};
/// From XYZ that is adapted to D65.
[[nodiscard]] spectral::Vec3 rgb_of(const spectral::Vec3& xyz_d65, const ColourTarget& target,
                                    const ColourChoices& choices, spectral::ColourOf what);

using ColourEvaluator = ordered_json (*)(const json& record, const ColourTarget& target,
                                         const ColourChoices& choices);

/// What is asked for on the command line.
struct ColourOptions : RecordFiles {
    ColourTargetOptions target;
    std::string adaptation = "bradford", gamut = "keep", range = "none", sampling = "adaptive";
    bool strict_range = false;
};

/// A kind of record with --space, --cat, --gamut, --range and --sampling.
CLI::App* add_colour_command(CLI::App& eval, Session& session, const char* name,
                             const char* description, const char* help,
                             const std::shared_ptr<ColourOptions>& options,
                             ColourEvaluator evaluate);

}  // namespace nacre::tool
