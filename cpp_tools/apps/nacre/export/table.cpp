// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "export/materials.h"
#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/media_library.h"
#include "shared/session.h"
#include "tables/image.h"
#include "tables/stack_table.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;

struct TableExport : ExportOptions {
    StackTableOptions stack;
    bool alpha = false, csv = false;
};

constexpr const char* kExportTableHelp = R"(
The table of nacre bake stack, and beside it FILE.json with its axes, units, stack, light, error and
citations, for engines that read no attributes. --alpha adds a channel of ones; with --depth half that
is RGBA16F. --csv adds FILE.csv, a row a texel.

  nacre export table --material soap_film --depth half --alpha -o soap_film.exr
  nacre export table my_film.toml --quantity transmittance --csv -o my_film_T.exr)";

/// What the values of the media rest on: one entry a medium of the library.
ordered_json citations(const kinds::MaterialTemplate& film)
{
    std::set<std::string> seen;
    ordered_json result = ordered_json::array();
    for (const material::MediumSpec* medium : film.kind->media()) {
        const auto* entry = std::get_if<material::LibraryMedium>(&medium->value);
        if (!entry || !seen.insert(entry->key).second) continue;
        const std::string& references = spectral::library_medium(entry->key).references;
        if (!references.empty())
            result.push_back({{"medium", entry->key}, {"references", references}});
    }
    return result;
}

ordered_json sidecar(const ExportedMaterial& material, const lut::Table& table,
                     const TableExport& options, const TableProvenance& provenance)
{
    ordered_json result = {{"schema", kTableSchema},
                           {"file", fs::path(options.output).filename().string()}};
    result.update(provenance_json(material, provenance));
    result.erase("roughness");
    if (const std::string name = material.varying(); !name.empty()) result.erase(name);
    std::vector<lut::Axis> axes{table.x};
    if (table.y.texels > 1) axes.push_back(table.y);
    ordered_json list = ordered_json::parse(axes_json(axes));
    for (std::size_t i = 0; i < axes.size(); ++i) list[i]["texels"] = axes[i].texels;
    result.update(
        {{"quantity", table.quantity},
         {"axes", std::move(list)},
         {"first_row", "top"},
         {"ends_at", "centres of the edge texels"},
         {"wrap", "clamp"},
         {"filter", "linear, no mip maps"},
         {"channels",
          options.alpha ? ordered_json{"R", "G", "B", "A"} : ordered_json{"R", "G", "B"}},
         {"depth", options.stack.depth.empty() ? "float" : options.stack.depth},
         {"encoding", "linear"},
         {"stack", ordered_json::parse(stack_json(material.film))},
         {"error", {{"max", table.error_max}, {"mean", table.error_mean}, {"unit", "dE00"}}},
         {"citations", citations(material.film)}});
    return result;
}

Image image_of(const lut::Table& table, bool alpha)
{
    Image image = table_image(table);
    if (!alpha) return image;
    Image with_alpha{image.width, image.height, {"R", "G", "B", "A"}, {}};
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        with_alpha.pixels.insert(with_alpha.pixels.end(), &image.pixels[i], &image.pixels[i] + 3);
        with_alpha.pixels.push_back(1.0F);
    }
    return with_alpha;
}

std::string csv_of(const lut::Table& table)
{
    const bool varies = table.y.texels > 1;
    std::string text = fmt::format("# {}; nacre info has the rest\n{}{}{},R,G,B\n", table.quantity,
                                   table.x.name, varies ? "," : "", varies ? table.y.name : "");
    for (int row = 0; row < table.y.texels; ++row)
        for (int column = 0; column < table.x.texels; ++column) {
            const float* texel = &table.texels[3 * (static_cast<std::size_t>(row) *
                                                        static_cast<std::size_t>(table.x.texels) +
                                                    static_cast<std::size_t>(column))];
            fmt::format_to(std::back_inserter(text), "{:.9g}", table.x.at(column));
            if (varies) fmt::format_to(std::back_inserter(text), ",{:.9g}", table.y.at(row));
            fmt::format_to(std::back_inserter(text), ",{:.9g},{:.9g},{:.9g}\n", texel[0], texel[1],
                           texel[2]);
        }
    return text;
}

int export_table(const Session& session, const TableExport& options)
{
    const Encoding encoding = table_encoding(options.output, options.stack.depth);
    if (encoding.container == Container::ftxt && options.alpha)
        throw InputError({options.output, 0, "--alpha", "goes with .exr and .tx only"});
    const ResolvedTableOptions resolved = resolve(options.table);
    const ExportedMaterial material =
        one_material(exported_materials(session, options, resolved, "a table"));
    if (material.is_body())
        throw InputError({material.source.file, 0, "glass",
                          "has no table; export it as gltf, "
                          "materialx or mitsuba"});
    check_writable(options.output);
    const lut::Table table = bake_stack_table(session, material.request, options.stack,
                                              encoding.depth, resolved.provenance.space);
    const TableProvenance provenance = table_provenance(material, resolved.provenance);
    const ordered_json description = sidecar(material, table, options, provenance);
    OutputFiles files;
    if (options.csv) files.add(fs::path(options.output).replace_extension(".csv"), csv_of(table));
    files.add(fs::path(options.output).replace_extension(".json"), description.dump(2) + "\n");
    files.add(options.output, encode_image(image_of(table, options.alpha),
                                           table_attributes(table, provenance), encoding));
    files.write();
    print_summary(session, ordered_json::array({description}),
                  {fmt::format("{}: {} x {} texels, ΔE00 mean {:.2g}, max {:.2g} between them",
                               material.source.id, table.x.texels, table.y.texels, table.error_mean,
                               table.error_max)});
    return kExitOk;
}

}  // namespace

void add_export_table(CLI::App& command, Session& session)
{
    const auto options = std::make_shared<TableExport>();
    CLI::App* table = command.add_subcommand("table", "a table of colours with a JSON beside it");
    table->footer(kExportTableHelp);
    add_export_options(*table, *options, ".exr, .tx or .ftxt");
    add_stack_table_options(*table, options->stack);
    table->add_flag("--alpha", options->alpha, "a fourth channel, 1 everywhere");
    table->add_flag("--csv", options->csv, "also FILE.csv");
    add_table_options(*table, options->table);
    table->callback([&session, options] {
        session.run = [&session, options] { return export_table(session, *options); };
    });
}

}  // namespace nacre::tool
