// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "shared/session.h"

namespace nacre::tool {

void add_eval(CLI::App& app, Session&)
{
    CLI::App* eval = app.add_subcommand("eval", "numbers without pictures: JSON in, JSON out");
    eval->fallthrough()->require_subcommand(1)->footer(R"(
A record, or an array of records, comes from a file or the standard input; -o FILE takes the answers.

  echo '{"blackbody_K": 2856}' | nacre eval spectrum
  nacre eval stack stack.json -o results.json)");
}

}  // namespace nacre::tool
