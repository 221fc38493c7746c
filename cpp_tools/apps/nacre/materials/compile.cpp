// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/stack_input.h"
#include "files/staged_folder.h"
#include "materials/compile.h"
#include "materials/shader_compiler.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/kinds/held_media.h"
#include "shared/held_ends.h"
#include "shared/session.h"
#include "shared/signals.h"
#include "tables/image.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCompileHelp = R"(
For each template the folder DIR/<id> with <id>.osl, the tables <id>_R.exr …, the manifest <id>.json,
and <id>.oso where oslc is on the path or NACRE_PYTHON names a Python with bpy. A folder is replaced
whole, and none is touched unless all templates compile. Equal input gives equal bytes.

  nacre compile osl/templates/*.toml -o materials
  nacre compile my_film.toml --tolerance 0.05 --space lin_rec2020_scene -o materials)";

struct Job {
    kinds::MaterialTemplate source;
    pipeline::CompiledMaterial compiled;
};

std::vector<kinds::MaterialTemplate> read_all(const std::vector<std::string>& inputs)
{
    std::vector<kinds::MaterialTemplate> sources;
    DiagnosticList problems;
    std::set<std::string> ids;
    for (const std::string& input : inputs) {
        try {
            sources.push_back(read_template_input(input));
            const std::string& id = sources.back().id;
            if (!ids.insert(id).second)
                problems.add(
                    {input, 0, "material.id",
                     fmt::format("must differ from the other templates' (got \"{}\")", id)});
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        }
    }
    problems.throw_if_any();
    return sources;
}

std::vector<Job> compile_all(std::vector<kinds::MaterialTemplate> sources,
                             kinds::CompileOptions options, Progress& progress)
{
    std::vector<Job> jobs;
    DiagnosticList problems;
    const auto count = static_cast<double>(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        options.progress = [&progress, i, count](double fraction) {
            progress.show((static_cast<double>(i) + fraction) / count);
            return !interrupted();
        };
        try {
            pipeline::CompiledMaterial compiled = pipeline::compile(sources[i], options);
            jobs.push_back({std::move(sources[i]), std::move(compiled)});
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        }
        check_interrupted();
    }
    problems.throw_if_any();
    return jobs;
}

/// The smallest file that holds the texels as they are.
Encoding encoding(const lut::Table& table)
{
    constexpr int kHalfBits = 10, kPxr24Bits = 15;
    return {Container::exr, table.texel_bits <= kHalfBits ? Depth::half : Depth::floating,
            table.texel_bits <= kPxr24Bits ? Compression::pxr24 : Compression::zip};
}

void write_tables(const fs::path& folder, const Job& job, const ResolvedTableOptions& options)
{
    TableProvenance provenance = options.provenance;
    for (const lut::Table& table : job.compiled.tables) {
        const kinds::MaterialTemplate source =
            table.role.is_bare ? kinds::without_layers(job.source) : job.source;
        provenance.stack = stack_json(source);
        provenance.held = held_media(source, options.compile);
        write_atomically(
            folder / fmt::format("{}_{}.exr", job.compiled.id, table.name()),
            encode_image(table_image(table), table_attributes(table, provenance), encoding(table)));
    }
}

/// A folder of somebody's own must not vanish because a material has its name.
void check_replaceable(const fs::path& target, const std::string& id)
{
    if (!fs::exists(target)) return;
    const bool empty = fs::is_directory(target) && fs::is_empty(target);
    if (!empty && !fs::is_regular_file(target / (id + ".json")))
        throw InputError(
            {target.string(), 0, "", "exists and is not a compiled material; move it away"});
}

ordered_json summary(const Job& job, const fs::path& folder)
{
    ordered_json tables = ordered_json::array();
    for (const lut::Table& table : job.compiled.tables)
        tables.push_back({{"name", table.name()},
                          {"width", table.x.texels},
                          {"height", table.y.texels},
                          {"error", {{"max", table.error_max}, {"mean", table.error_mean}}}});
    return {{"id", job.compiled.id}, {"folder", folder.string()}, {"tables", std::move(tables)}};
}

int compile_command(const Session& session, const CompileRequest& request)
{
    ordered_json list = ordered_json::array();
    for (const CompiledFolder& folder : compile_templates(session, request)) {
        note_held(session, folder.held);
        list.push_back(folder.summary);
    }
    if (session.json) write_text_output("", list.dump(2) + "\n");
    return kExitOk;
}

}  // namespace

std::vector<CompiledFolder> compile_templates(const Session& session, const CompileRequest& request)
{
    const ResolvedTableOptions resolved = resolve(request.table);
    std::vector<Job> jobs;
    {
        Progress progress(session);
        jobs = compile_all(read_all(request.inputs), resolved.compile, progress);
    }
    const fs::path& output = request.output;
    for (const Job& job : jobs) check_replaceable(output / job.compiled.id, job.compiled.id);

    const WritingGuard guard;
    const auto shader_compiler = request.shader_bytecode ? ShaderCompiler::find() : std::nullopt;
    if (shader_compiler)
        session.detail("shaders are compiled by " + shader_compiler->description());
    std::vector<StagedFolder> staged;
    for (const Job& job : jobs) {
        const std::string& id = job.compiled.id;
        const fs::path& folder = staged.emplace_back(output / id).path();
        write_atomically(folder / (id + ".osl"), job.compiled.osl);
        write_atomically(folder / (id + ".json"), job.compiled.manifest);
        write_tables(folder, job, resolved);
        check_interrupted();
        if (shader_compiler) shader_compiler->compile(folder, id);
        check_interrupted();
    }
    std::vector<CompiledFolder> result;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        staged[i].commit();
        const fs::path folder = output / jobs[i].compiled.id;
        result.push_back({jobs[i].compiled.id, folder, held_media(jobs[i].source, resolved.compile),
                          summary(jobs[i], folder)});
        session.detail(fmt::format("wrote {}", folder.string()));
    }
    return result;
}

void add_compile(CLI::App& app, Session& session)
{
    const auto options = std::make_shared<CompileRequest>();
    CLI::App* compile = app.add_subcommand("compile", "templates to shaders, tables and manifests");
    compile->fallthrough()->footer(kCompileHelp);
    compile->add_option("TEMPLATE", options->inputs, "template files (.toml), shaders (.osl)")
        ->required();
    compile->add_option("-o,--output", options->output, "folder to write to")
        ->required()
        ->type_name("DIR");
    add_table_options(*compile, options->table);
    compile->callback([&session, options] {
        session.run = [&session, options] { return compile_command(session, *options); };
    });
}

}  // namespace nacre::tool
