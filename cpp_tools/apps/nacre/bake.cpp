// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "bake.h"

#include <CLI/CLI.hpp>

#include "session.h"

namespace nacre::tool {

void add_bake(CLI::App& app, Session& session)
{
    CLI::App* bake =
        app.add_subcommand("bake", "textures with their axes, units and origin inside");
    bake->fallthrough()->require_subcommand(1)->footer(R"(
  nacre bake stack osl/templates/soap_film.toml -o soap_film.exr
  nacre bake lights D65 lamp/hps -o lights.exr)");
    add_bake_cmf(*bake, session);
    add_bake_material(*bake, session);
    add_bake_ramp(*bake, session);
    add_bake_spectra(*bake, session);
    add_bake_stack(*bake, session);
}

}  // namespace nacre::tool
