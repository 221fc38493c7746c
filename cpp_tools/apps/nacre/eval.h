// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "colour_target.h"
#include "json_input.h"

/// @file
/// The records of `nacre eval`: one JSON object in, one out.

namespace nacre::tool {

/// Answers one record. @throws InputError with every problem of the record.
using RecordEvaluator = std::function<ordered_json(const json& record)>;

[[nodiscard]] ordered_json evaluate_stack(const json& record);
[[nodiscard]] ordered_json evaluate_grating(const json& record);
[[nodiscard]] ordered_json evaluate_spectrum(const json& record, const ColourTarget& target);

}  // namespace nacre::tool
