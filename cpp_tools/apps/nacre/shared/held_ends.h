// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "nacre/media/working_range.h"

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

/// @file
/// How commands take media whose data end within 360 … 830 nm, and say so.

namespace nacre::tool {

struct Session;

/// --strict-range
void add_strict_range(CLI::App& command, bool& strict);
[[nodiscard]] spectral::RangeRule range_rule(bool strict) noexcept;

/// A note for each.
void note_held(const Session& session, const std::vector<spectral::HeldEnds>& held);

/// Where a result has a place for it: `[{"medium", "range_nm", "percent", "note"}, …]`, as in a
/// manifest (cpp_tools/doc/manifest.md).
[[nodiscard]] nlohmann::ordered_json held_json(const std::vector<spectral::HeldEnds>& held);

}  // namespace nacre::tool
