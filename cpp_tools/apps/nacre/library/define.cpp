// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "library/shape_options.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/user_library.h"
#include "nacre/readers/spectrum_files.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::EntryKind;
using spectral::NamedSpectrum;
using spectral::SpectrumKind;

struct DefineOptions {
    std::string key, output, kind, name, citation, licence;
    std::vector<std::string> tags;
    ShapeOptions shapes;
    bool replace = false;
};

void check_target(const DefineOptions& options)
{
    if (options.key.empty() == options.output.empty())
        throw InputError({{}, 0, "KEY", "must be given, or else --output FILE.csv, and not both"});
    const bool csv =
        options.output == "-" || std::filesystem::path(options.output).extension() == ".csv";
    if (!options.output.empty() && !csv)
        throw InputError({options.output, 0, {}, "must end in .csv"});
}

NamedSpectrum defined(const DefineOptions& options)
{
    NamedSpectrum spectrum{
        .key = {},
        .name = options.name,
        .references = options.citation,
        .licence = options.licence,
        .comments = shapes_text(options.shapes),
        .tags = options.tags,
        .kind = options.kind == "emission" ? SpectrumKind::emission : SpectrumKind::reflectance,
        .samples = spectrum_of_shapes(options.shapes)};
    if (auto problem = spectral::kind_problem(spectrum.samples, *spectrum.kind))
        throw InputError({{}, 0, "--kind", "the sum does not suit: " + *problem});
    return spectrum;
}

int define(const Session& session, const DefineOptions& options)
{
    check_target(options);
    const NamedSpectrum spectrum = defined(options);
    std::string text = write_library_spectrum(spectrum);
    // What is saved can be read.
    (void)spectral::read_library_spectrum(text, "the spectrum");
    if (!options.output.empty()) {
        write_text_output(options.output, text);
        return kExitOk;
    }
    const auto files = spectral::save_user_entries(
        {{EntryKind::spectrum, options.key, std::move(text)}}, options.replace);
    const std::string file = files.front().string();
    write_text_output("", session.json
                              ? ordered_json{{"key", options.key}, {"file", file}}.dump(2) + "\n"
                              : fmt::format("{:<28} {}\n", options.key, file));
    return kExitOk;
}

constexpr const char* kLibraryDefineHelp =
    "\n  nacre library define paint/teal --kind reflectance --constant 0.05 --gaussian 490:80:0.4\n"
    "  nacre library define lamp/mix --kind emission --from lamp/hps:0.5 --from cie/D65:0.01\n"
    "  nacre library define --kind reflectance --interpolation smooth \\\n"
    "      --points 400:0.1,500:0.7,600:0.3 -o curve.csv";

}  // namespace

void add_library_define(CLI::App& library, Session& session)
{
    const auto options = std::make_shared<DefineOptions>();
    CLI::App* command =
        library.add_subcommand("define", "a spectrum made by hand, the sum of simple shapes");
    command->fallthrough()->footer(kLibraryDefineHelp);
    command->add_option("KEY", options->key, "of the new entry of your own library");
    command->add_option("-o,--output", options->output, ".csv or -, in place of a library");
    command->add_option("--kind", options->kind, "what the values are")
        ->required()
        ->check(CLI::IsMember({"reflectance", "emission"}));
    add_shape_options(*command, options->shapes);
    command->add_option("--name", options->name, "readable name");
    command->add_option("--citation", options->citation, "where the numbers are from");
    command->add_option("--licence", options->licence, "on what terms they may be used");
    command->add_option("--tags", options->tags, "words to find it by, e.g. paint,blue")
        ->delimiter(',')
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
    command->add_flag("--replace", options->replace,
                      "take the place of your own entry of that key");
    command->callback([&session, options] {
        session.run = [&session, options] { return define(session, *options); };
    });
}

}  // namespace nacre::tool
