// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "export/materials.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/core/version.h"
#include "nacre/kinds/held_media.h"
#include "nacre/kinds/shipped.h"
#include "nacre/library/lights.h"
#include "nacre/pipeline/compile.h"
#include "shared/held_ends.h"
#include "shared/session.h"
#include "shared/signals.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;
using kinds::MaterialTemplate;

MaterialTemplate library_template(const std::string& id)
{
    if (auto found = kinds::shipped_template(id)) return *std::move(found);
    throw InputError({"", 0, "--material",
                      fmt::format("must be a material of the library, such as soap_film or "
                                  "tempered_steel (got {})",
                                  id)});
}

std::vector<MaterialTemplate> read_sources(const ExportOptions& options, DiagnosticList& problems)
{
    std::vector<MaterialTemplate> sources;
    std::set<std::string> ids;
    const auto add = [&](auto read, const std::string& name) {
        try {
            MaterialTemplate source = read(name);
            if (!ids.insert(source.id).second)
                problems.add(
                    {source.file, 0, "material.id",
                     fmt::format("must differ from the other materials' (got \"{}\")", source.id)});
            sources.push_back(std::move(source));
        } catch (const InputError& error) {
            for (const Diagnostic& problem : error.diagnostics()) problems.add(problem);
        }
    };
    for (const std::string& file : options.templates) add(read_template_input, file);
    for (const std::string& id : options.materials) add(library_template, id);
    return sources;
}

/// The film that stands for the material.
MaterialTemplate film_for(const MaterialTemplate& source, const char* format)
{
    auto found = source.kind->exported(source);
    if (const auto* reason = std::get_if<std::string>(&found))
        throw InputError({source.file, 0, std::string(source.kind->name()),
                          fmt::format("has no counterpart in {}: {}", format, *reason)});
    return std::get<MaterialTemplate>(std::move(found));
}

/// The number that a material has by this name, and what it may be.
struct Socket {
    double* value;
    double min, max;
    const char* unit;
};

std::optional<Socket> socket(ExportedMaterial& material, const std::string& name)
{
    if (name == "roughness") {
        const auto* parameter = material.source.parameter("roughness");
        return Socket{&material.roughness, parameter ? parameter->min : 0.0,
                      parameter ? parameter->max : 1.0, ""};
    }
    if (name.empty() || name != material.varying()) return std::nullopt;
    const lut::Variation& variation = *material.request.variation;
    return Socket{&material.value, variation.min, variation.max, variation.layer ? " nm" : ""};
}

void assign(ExportedMaterial& material, const std::string& text, DiagnosticList& problems)
{
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals), field = "--set " + text;
    const auto refuse = [&](std::string message) {
        problems.add({"", 0, field, std::move(message)});
    };
    if (equals == std::string::npos) return refuse("must be NAME=VALUE");
    const std::optional<Socket> target = socket(material, name);
    if (!target) {
        const std::string varying = material.varying();
        return refuse(fmt::format("{} has no value {}; there are: {}{}roughness",
                                  material.source.id, name, varying, varying.empty() ? "" : ", "));
    }
    const char *first = text.data() + equals + 1, *last = text.data() + text.size();
    double value = 0.0;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc{} || end != last || !std::isfinite(value))
        return refuse("must be a number");
    if (value < target->min || value > target->max)
        return refuse(fmt::format("must be in [{:g}, {:g}]{} for {}", target->min, target->max,
                                  target->unit, material.source.id));
    *target->value = value;
}

double default_value(const kinds::Film& film)
{
    if (const auto layer = film.varying_layer()) return film.layers[*layer].thickness_nm.value;
    return film.scale ? film.scale->value : 0.0;
}

ExportedMaterial prepared(MaterialTemplate source, const ResolvedTableOptions& table,
                          const char* format)
{
    ExportedMaterial result;
    result.film = film_for(source, format);
    result.request = kinds::film_request(result.film, table.compile);
    result.held = held_media(result.film, table.compile);
    result.value = default_value(result.stack());
    const auto* roughness = source.parameter("roughness");
    result.roughness = roughness ? roughness->value : source.roughness;
    result.source = std::move(source);
    return result;
}

}  // namespace

void add_export_options(CLI::App& command, ExportOptions& options, const char* output_help)
{
    command.fallthrough();
    command.add_option("TEMPLATE", options.templates, "files (.toml, .json)");
    command.add_option("--material", options.materials, "of the library, by id; may be repeated")
        ->allow_extra_args(false)
        ->type_name("ID");
    command.add_option("-o,--output", options.output, output_help)->required();
}

void add_value_options(CLI::App& command, ExportOptions& options)
{
    command
        .add_option("--set", options.assignments,
                    "thickness_nm, thickness_scale or roughness; default: the template's")
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
}

std::string ExportedMaterial::varying() const
{
    return film.kind->driven_socket();
}

bool ExportedMaterial::is_body() const
{
    return source.kind->traits().is_body;
}

std::vector<ExportedMaterial> exported_materials(const Session& session,
                                                 const ExportOptions& options,
                                                 const ResolvedTableOptions& table,
                                                 const char* format)
{
    DiagnosticList problems;
    if (options.templates.empty() && options.materials.empty())
        problems.add({"", 0, "TEMPLATE", "must be given, or --material ID"});
    std::vector<ExportedMaterial> materials;
    for (MaterialTemplate& source : read_sources(options, problems)) {
        try {
            materials.push_back(prepared(std::move(source), table, format));
        } catch (const InputError& error) {
            for (const Diagnostic& problem : error.diagnostics()) problems.add(problem);
            continue;
        }
        for (const std::string& text : options.assignments)
            assign(materials.back(), text, problems);
    }
    problems.throw_if_any();
    for (const ExportedMaterial& material : materials) note_held(session, material.held);
    return materials;
}

ExportedMaterial one_material(std::vector<ExportedMaterial> materials)
{
    if (materials.size() > 1)
        throw InputError({materials[1].source.file, 0, "",
                          fmt::format("must be the only material: the file holds one (got {})",
                                      materials.size())});
    return std::move(materials.front());
}

void for_each_material(const Session& session, const std::vector<ExportedMaterial>& materials,
                       const std::function<void(const ExportedMaterial&)>& act)
{
    Progress progress(session);
    for (std::size_t i = 0; i < materials.size(); ++i) {
        progress.show(static_cast<double>(i) / static_cast<double>(materials.size()));
        act(materials[i]);
    }
}

std::complex<double> index_at(const lut::IndexOnGrid& medium, double wavelength_nm)
{
    const double place = wavelength_nm - spectral::kFirstNm;
    const auto below = static_cast<std::size_t>(place);
    const double fraction = place - std::floor(place);
    return (1.0 - fraction) * medium[below] + fraction * medium[below + 1];
}

double relative_index(const ExportedMaterial& material)
{
    const lut::SampledStack& stack = material.request.stack;
    return index_at(stack.substrate, kLineD).real() / index_at(stack.ambient, kLineD).real();
}

TableProvenance table_provenance(const ExportedMaterial& material, TableProvenance provenance)
{
    provenance.stack = stack_json(material.film);
    provenance.held = material.held;
    return provenance;
}

lut::FilmTableRequest rec709_request(const ExportedMaterial& material,
                                     const TableProvenance& provenance)
{
    lut::FilmTableRequest request = material.request;
    request.weights = spectral::reflectance_weights(
        spectral::named_illuminant(provenance.illuminant), provenance.observer,
        spectral::colour_space("lin_rec709_scene"), provenance.adaptation);
    return request;
}

ordered_json provenance_json(const ExportedMaterial& material, const TableProvenance& provenance)
{
    const MaterialTemplate& source = material.source;
    ordered_json result = {{"id", source.id},
                           {"name", source.name},
                           {"description", source.description},
                           {"source", source.source},
                           {"status", material::status_name(source.status)},
                           {"generator", fmt::format("Nacre {}", version())}};
    if (const std::string name = material.varying(); !name.empty()) result[name] = material.value;
    result["roughness"] = material.roughness;
    result["illuminant"] = provenance.illuminant;
    result["observer"] = spectral::observer_name(provenance.observer);
    result["adaptation"] = spectral::adaptation_name(provenance.adaptation);
    result["space"] = provenance.space.name;
    if (!material.held.empty()) result["held_ends"] = held_json(material.held);
    return result;
}

ordered_json error_json(const lut::SphereError& error)
{
    // Four digits: what a platform's mathematics library rounds differently must not show.
    const auto cut = [](double value) { return std::round(value * 1e4) / 1e4; };
    return {{"mean", cut(error.mean)}, {"max", cut(error.max)}, {"unit", "dE00"}};
}

void OutputFiles::add(const fs::path& path, std::string bytes)
{
    files_.emplace_back(path, std::move(bytes));
}

void OutputFiles::write() const
{
    const WritingGuard guard;
    std::vector<std::unique_ptr<AtomicFile>> aside;
    for (const auto& [path, bytes] : files_) {
        aside.push_back(std::make_unique<AtomicFile>(path));
        std::ofstream stream(aside.back()->temporary(), std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.close();
        if (!stream) throw InputError({path.string(), 0, "", "cannot be written"});
    }
    for (const auto& file : aside) file->commit();
}

void print_summary(const Session& session, const ordered_json& list,
                   const std::vector<std::string>& lines)
{
    if (session.json) {
        write_text_output("", list.dump(2) + "\n");
    } else if (!session.quiet) {
        std::string text;
        for (const std::string& line : lines) text += line + "\n";
        write_text_output("", text);
    }
}

}  // namespace nacre::tool
