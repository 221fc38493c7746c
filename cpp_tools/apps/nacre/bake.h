// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): not ours
class App;
}

/// @file
/// The kinds of `nacre bake`.

namespace nacre::tool {

struct Session;

void add_bake_cmf(CLI::App& bake, Session& session);
void add_bake_material(CLI::App& bake, Session& session);
void add_bake_ramp(CLI::App& bake, Session& session);
void add_bake_spectra(CLI::App& bake, Session& session);
void add_bake_stack(CLI::App& bake, Session& session);

}  // namespace nacre::tool
