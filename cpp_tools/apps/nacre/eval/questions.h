// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/json_input.h"
#include "nacre/optics/fresnel.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/observer.h"

/// @file
/// Fields that several kinds of records have.

namespace nacre::tool {

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

}  // namespace nacre::tool
