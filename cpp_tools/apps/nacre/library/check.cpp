// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/kinds/held_media.h"
#include "nacre/pipeline/compile.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "shared/held_ends.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;

struct CheckOptions {
    std::vector<std::string> files;
    bool strict_range = false;
};

/// What is put right when a file is read, and media that are held.
struct Findings {
    std::vector<std::string> changes;
    std::vector<spectral::HeldEnds> held;
};

/// @throws InputError with what is wrong with a file of optical constants or a template
Findings check_file(const std::string& file, bool strict_range)
{
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension == ".yml" || extension == ".yaml") {
        return {spectral::parse_refractiveindex_yaml(read_text(file), file).changes, {}};
    } else if (extension == ".csv") {
        (void)spectral::read_library_spectrum(read_text(file), file);
    } else if (extension == ".toml" || extension == ".json" || extension == ".osl") {
        const kinds::MaterialTemplate source = read_template_input(file);
        kinds::CompileOptions options;
        options.range = range_rule(strict_range);
        source.kind->check(source, options);
        return {{}, held_media(source, options)};
    } else {
        throw InputError({file, 0, "",
                          "must be optical constants (.yml), a spectrum (.csv) or a template "
                          "(.toml, .json, .osl)"});
    }
    return {};
}

int check_files(const Session& session, const CheckOptions& options)
{
    DiagnosticList problems;
    for (const std::string& file : options.files) {
        try {
            const Findings found = check_file(file, options.strict_range);
            for (const std::string& change : found.changes)
                session.note(fmt::format("{}: changed: {}", file, change));
            note_held(session, found.held);
            session.detail(file + ": ok");
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        }
    }
    problems.throw_if_any();
    if (session.json)
        write_text_output("", ordered_json{{"checked", options.files}}.dump(2) + "\n");
    return kExitOk;
}

}  // namespace

void add_library_check(CLI::App& library, Session& session)
{
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* check =
        library.add_subcommand("check", "validates optical constants, spectra and templates");
    check->fallthrough()->footer("\n  nacre library check my_glass.yml my_film.toml");
    check
        ->add_option("FILE", options->files,
                     "refractiveindex.info YAML (.yml), spectrum (.csv), template (.toml, .json)")
        ->required();
    add_strict_range(*check, options->strict_range);
    check->callback([&session, options] {
        session.run = [&session, options] { return check_files(session, *options); };
    });
}

}  // namespace nacre::tool
