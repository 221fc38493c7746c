// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "bake/ramp.h"
#include "export/materials.h"
#include "files/output.h"
#include "nacre/core/diagnostics.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

struct RampExport : ExportOptions {
    RampOptions ramp;
};

constexpr const char* kExportRampsHelp = R"(
Exact colours at equal steps of the thickness, at one angle; the same as nacre bake ramp.

  nacre export cube --material tempered_steel -o tempered_steel.cube
  nacre export csv --material soap_film --angle 45 --size 8 -o soap_film.csv)";

int export_ramp(const Session& session, const RampExport& options, RampFormat format,
                const std::string& name)
{
    if (ramp_format(options.output) != format)
        throw InputError({options.output, 0, "-o", fmt::format("must end in .{}", name)});
    const ResolvedTableOptions table = resolve(options.table);
    const ExportedMaterial material =
        one_material(exported_materials(session, options, table, "a ramp"));
    check_writable(options.output);
    write_text_output(options.output, ramp_text(material.source, options.ramp, table, format));
    ordered_json summary = provenance_json(material, table.provenance);
    summary["size"] = options.ramp.size;
    print_summary(session, ordered_json::array({summary}), {});
    return kExitOk;
}

void add_format(CLI::App& command, Session& session, RampFormat format, const std::string& name,
                const char* description)
{
    const auto options = std::make_shared<RampExport>();
    CLI::App* ramp = command.add_subcommand(name, description);
    ramp->footer(kExportRampsHelp);
    add_export_options(*ramp, *options, name == "cube" ? ".cube" : ".csv");
    add_ramp_options(*ramp, options->ramp);
    add_light_options(*ramp, options->table);
    ramp->callback([&session, options, format, name] {
        session.run = [&session, options, format, name] {
            return export_ramp(session, *options, format, name);
        };
    });
}

}  // namespace

void add_export_cube(CLI::App& command, Session& session)
{
    add_format(command, session, RampFormat::cube, "cube",
               "colours over thickness as a 1-D table of Adobe and DaVinci");
}

void add_export_csv(CLI::App& command, Session& session)
{
    add_format(command, session, RampFormat::csv, "csv", "colours over thickness as rows");
}

}  // namespace nacre::tool
