// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "shared/session.h"

namespace nacre::tool {

void add_library(CLI::App& app, Session&)
{
    CLI::App* library =
        app.add_subcommand("library", "optical constants, spectra, illuminants, templates");
    library->fallthrough()->require_subcommand(1)->footer(R"(
  nacre library list iron
  nacre library show Fe/Johnson --at 550)");
}

}  // namespace nacre::tool
