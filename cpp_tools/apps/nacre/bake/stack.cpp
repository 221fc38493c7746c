// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/kinds/held_media.h"
#include "nacre/pipeline/compile.h"
#include "shared/held_ends.h"
#include "shared/session.h"
#include "tables/image.h"
#include "tables/options.h"
#include "tables/stack_table.h"

namespace nacre::tool {
namespace {

struct StackOptions {
    std::string input, output;
    StackTableOptions table;
    TableOptions colour;
};

constexpr const char* kBakeStackHelp = R"(
INPUT is a film template (.toml), or the JSON of one (.json; - is the standard input):
  {"ambient": {"medium": "air"},
   "layer": [{"n": 1.33, "thickness_nm": {"default": 400, "min": 0, "max": 1500, "varies": true}}],
   "substrate": {"medium": "air"}}
with the keys of a template; "schema" and "material" may be left out. Media are library keys
("medium"), n and k, cauchy, sellmeier or abbe.

The table runs over cosθ (left 0, right 1) and, from the top row down, what varies. The centres of the
edge texels hold the ends of the axes. Axes, stack, light, observer, space and the measured error are
attributes of the file: see nacre info.

  nacre bake stack osl/templates/soap_film.toml -o soap_film.exr
  nacre bake stack osl/templates/soap_film.toml --quantity transmittance --depth half -o soap_T.exr
  nacre bake stack film.json --tolerance 0.05 --space lin_ap1_scene -o film.tx)";

int bake(const Session& session, const StackOptions& options)
{
    const Encoding encoding = table_encoding(options.output, options.table.depth);
    const kinds::MaterialTemplate source = read_template_input(options.input);
    static_cast<void>(kinds::film_of(source, "must be a film: no other kind has such a table"));

    const ResolvedTableOptions resolved = resolve(options.colour);
    const lut::FilmTableRequest request = kinds::film_request(source, resolved.compile);
    TableProvenance provenance = resolved.provenance;
    provenance.stack = stack_json(source);
    provenance.held = held_media(source, resolved.compile);
    note_held(session, provenance.held);
    check_writable(options.output);
    const lut::Table table = bake_stack_table(session, request, options.table, encoding.depth,
                                              resolved.provenance.space);
    write_text_output(options.output, encode_image(table_image(table),
                                                   table_attributes(table, provenance), encoding));
    session.detail(fmt::format("{}: {} x {} texels, ΔE00 max {:.3g}, mean {:.3g}", options.output,
                               table.x.texels, table.y.texels, table.error_max, table.error_mean));
    return kExitOk;
}

}  // namespace

void add_bake_stack(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<StackOptions>();
    CLI::App* stack =
        bake_command.add_subcommand("stack", "colour of a film over angle and thickness");
    stack->fallthrough()->footer(kBakeStackHelp);
    stack->add_option("INPUT", options->input, "template (.toml) or stack (.json, -)")->required();
    stack->add_option("-o,--output", options->output, ".exr, .tx or .ftxt")->required();
    add_stack_table_options(*stack, options->table);
    add_table_options(*stack, options->colour);
    stack->callback([&session, options] {
        session.run = [&session, options] { return bake(session, *options); };
    });
}

}  // namespace nacre::tool
