// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "colour_target.h"
#include "json_input.h"
#include "nacre/optics/fresnel.h"
#include "nacre/spectral/colour_quadrature.h"
#include "nacre/spectral/gamut.h"
#include "nacre/spectral/working_range.h"

/// @file
/// The records of `nacre eval`: one JSON object in, one out.

namespace nacre::tool {

/// Answers one record. @throws InputError with every problem of the record.
using RecordEvaluator = std::function<ordered_json(const json& record)>;

/// `n`: indices [n, k] or n alone, from a clear ambient to the substrate; nothing where one is
/// wrong.
[[nodiscard]] std::vector<optics::Complex> read_indices(ObjectReader& reader,
                                                        DiagnosticList& problems);

/// `coherence`: one flag a layer, true where it is coherent.
[[nodiscard]] std::vector<bool> read_coherence(ObjectReader& reader, std::size_t layers);

/// `angle_deg` in the ambient, by default 0: straight on.
[[nodiscard]] std::optional<double> read_angle(ObjectReader& reader);

/// `pol`: s, p or u, by default u.
[[nodiscard]] std::optional<std::string> read_polarisation(ObjectReader& reader);

/// `observer`, by default CIE 1931.
[[nodiscard]] spectral::ObserverId read_observer(ObjectReader& reader);

/// `illuminant`, which is there; nothing where it is wrong.
[[nodiscard]] std::optional<spectral::Illuminant> read_illuminant(ObjectReader& reader);

[[nodiscard]] ordered_json evaluate_film(const json& record);
[[nodiscard]] ordered_json evaluate_slits(const json& record);
[[nodiscard]] ordered_json evaluate_stack(const json& record);
[[nodiscard]] ordered_json evaluate_grating(const json& record);

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
[[nodiscard]] ordered_json evaluate_colour(const json& record, const ColourTarget& target,
                                           const ColourChoices& choices);
[[nodiscard]] ordered_json evaluate_spectrum(const json& record, const ColourTarget& target,
                                             const ColourChoices& choices);

}  // namespace nacre::tool
