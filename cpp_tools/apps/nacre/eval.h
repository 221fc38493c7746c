// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "colour_target.h"
#include "json_input.h"
#include "nacre/optics/fresnel.h"
#include "nacre/spectral/gamut.h"

/// @file
/// The records of `nacre eval`: one JSON object in, one out.

namespace nacre::tool {

/// Answers one record. @throws InputError with every problem of the record.
using RecordEvaluator = std::function<ordered_json(const json& record)>;

/// `n`: indices [n, k] or n alone, from a clear ambient to the substrate; nothing where one is
/// wrong.
[[nodiscard]] std::vector<optics::Complex> read_indices(ObjectReader& reader,
                                                        DiagnosticList& problems);

[[nodiscard]] ordered_json evaluate_film(const json& record);
[[nodiscard]] ordered_json evaluate_slits(const json& record);
[[nodiscard]] ordered_json evaluate_stack(const json& record);
[[nodiscard]] ordered_json evaluate_grating(const json& record);

/// How `evaluate_spectrum` comes from XYZ to rgb.
struct ColourChoices {
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    spectral::GamutMapping gamut = spectral::GamutMapping::keep;
};
[[nodiscard]] ordered_json evaluate_spectrum(const json& record, const ColourTarget& target,
                                             const ColourChoices& choices);

}  // namespace nacre::tool
