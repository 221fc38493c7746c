// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0

#include <CLI/CLI.hpp>

#include "shared/session.h"

namespace nacre::tool {

void add_bake(CLI::App& app, Session&)
{
    CLI::App* bake =
        app.add_subcommand("bake", "textures with their axes, units and origin inside");
    bake->fallthrough()->require_subcommand(1)->footer(R"(
  nacre bake stack osl/templates/soap_film.toml -o soap_film.exr
  nacre bake lights D65 lamp/hps -o lights.exr)");
}

}  // namespace nacre::tool
