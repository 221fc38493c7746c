// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "shared/session.h"

namespace nacre::tool {
namespace {

constexpr const char* kExportHelp = R"(
Materials are templates of one's own (TEMPLATE.toml), or come from the library (--material ID):
  materialx  .mtlx: table and node graph of any film, and a closure with a thin film where there is one
  gltf       .gltf, .glb: the nearest KHR_materials_iridescence; of glasses ior and dispersion
  mitsuba    .xml for Mitsuba 3: exact reflectance over angle and wavelength, its plugin beside it
  table      .exr, .tx with a .json beside it, and .csv
  cube, csv  exact colours over thickness at one angle

Each states how far its colours are from the exact ones, in the file, and on the standard output.

  nacre export gltf --material soap_film -o soap_film.glb
  nacre export materialx --material tempered_steel --set thickness_nm=48 -o steel.mtlx
  nacre export mitsuba my_film.toml -o my_film.xml)";

}  // namespace

void add_export(CLI::App& app, Session&)
{
    CLI::App* command = app.add_subcommand("export", "materials for other programs and renderers");
    command->fallthrough()->require_subcommand(1)->footer(kExportHelp);
}

}  // namespace nacre::tool
