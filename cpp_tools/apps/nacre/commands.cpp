// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <string_view>

#include <CLI/CLI.hpp>

#include "shared/session.h"

// The one list of commands, in the order of help. COMMAND("bake", bake_stack) has add_bake_stack()
// hang a command below `nacre bake`: it stands beside the help, the options and the work of the
// command. A group comes before what is in it.
#define NACRE_COMMANDS(COMMAND)         \
    COMMAND("", eval)                   \
    COMMAND("eval", eval_stack)         \
    COMMAND("eval", eval_film)          \
    COMMAND("eval", eval_slits)         \
    COMMAND("eval", eval_grating)       \
    COMMAND("eval", eval_spectrum)      \
    COMMAND("eval", eval_colour)        \
    COMMAND("", bake)                   \
    COMMAND("bake", bake_cmf)           \
    COMMAND("bake", bake_material)      \
    COMMAND("bake", bake_lights)        \
    COMMAND("bake", bake_ramp)          \
    COMMAND("bake", bake_spectra)       \
    COMMAND("bake", bake_stack)         \
    COMMAND("", compile)                \
    COMMAND("", library)                \
    COMMAND("library", library_list)    \
    COMMAND("library", library_show)    \
    COMMAND("library", library_check)   \
    COMMAND("library", library_define)  \
    COMMAND("library", library_import)  \
    COMMAND("library", library_schema)  \
    COMMAND("", info)                   \
    COMMAND("", compare)                \
    COMMAND("", render)                 \
    COMMAND("", develop)                \
    COMMAND("", export)                 \
    COMMAND("export", export_materialx) \
    COMMAND("export", export_gltf)      \
    COMMAND("export", export_mitsuba)   \
    COMMAND("export", export_table)     \
    COMMAND("export", export_cube)      \
    COMMAND("export", export_csv)

namespace nacre::tool {

#define NACRE_DECLARE(group, name) void add_##name(CLI::App& parent, Session& session);
NACRE_COMMANDS(NACRE_DECLARE)

void add_commands(CLI::App& app, Session& session)
{
    const auto group_of = [&app](const std::string& group) -> CLI::App& {
        return group.empty() ? app : *app.get_subcommand(group);
    };
#define NACRE_ADD(group, name) add_##name(group_of(group), session);
    NACRE_COMMANDS(NACRE_ADD)
}

}  // namespace nacre::tool
