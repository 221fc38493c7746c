// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/core/resources.h"
#include "nacre/pipeline/compile.h"
#include "nacre/spectral/optical_constants.h"
#include "output.h"
#include "session.h"
#include "stack_input.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::Medium;

struct LibraryOptions {
    std::string filter, tag, kind = "media", key;
    std::vector<double> wavelengths_nm;
    std::vector<std::string> files;
};

ordered_json range_json(const Medium& medium)
{
    const auto [first, last] = medium.constants->range_nm();
    if (!std::isfinite(last)) return nullptr;
    return {first, last};
}

std::string range_text(const Medium& medium)
{
    const auto [first, last] = medium.constants->range_nm();
    return std::isfinite(last) ? fmt::format("{:g} … {:g} nm", first, last) : "any wavelength";
}

/// Searches without regard to case.
bool matches(const std::string& text, const std::string& filter)
{
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), filter.begin(), filter.end(), same) != text.end();
}

bool is_tagged(const Medium& medium, const std::string& tag)
{
    return tag.empty() || std::ranges::find(medium.tags, tag) != medium.tags.end();
}

void list_media(const LibraryOptions& options, ordered_json& list, std::string& text)
{
    for (const std::string& key : spectral::library_keys()) {
        const Medium& medium = spectral::library_medium(key);
        if (!is_tagged(medium, options.tag) ||
            !matches(fmt::format("{} {} {} {} {}", key, medium.name, medium.formula,
                                 fmt::join(medium.tags, " "), medium.references),
                     options.filter))
            continue;
        list.push_back({{"key", key},
                        {"name", medium.name},
                        {"formula", medium.formula},
                        {"tags", medium.tags},
                        {"range_nm", range_json(medium)}});
        text += fmt::format("{:<28} {:<20} {}\n", key, range_text(medium), medium.name);
    }
}

void list_names(const std::vector<std::string>& names, const std::string& filter,
                ordered_json& list, std::string& text)
{
    for (const std::string& name : names) {
        if (!matches(name, filter)) continue;
        list.push_back({{"key", name}});
        text += name + "\n";
    }
}

std::vector<std::string> template_ids()
{
    std::vector<std::string> ids;
    for (const std::string_view path : list_resources("templates/"))
        ids.push_back(std::filesystem::path(path).stem().string());
    return ids;
}

int list_library(const Session& session, const LibraryOptions& options)
{
    ordered_json list = ordered_json::array();
    std::string text;
    if (options.kind == "media") list_media(options, list, text);
    if (options.kind == "illuminants")
        list_names(spectral::illuminant_names(), options.filter, list, text);
    if (options.kind == "spaces")
        list_names(spectral::colour_space_names(), options.filter, list, text);
    if (options.kind == "templates") list_names(template_ids(), options.filter, list, text);
    write_text_output("", session.json ? list.dump(2) + "\n" : text);
    return kExitOk;
}

int show_medium(const Session& session, const LibraryOptions& options)
{
    const Medium& medium = spectral::library_medium(options.key);
    ordered_json at = ordered_json::array();
    std::string values;
    for (const double nm : options.wavelengths_nm) {
        const spectral::Complex n = medium.constants->at(nm);
        at.push_back({{"wavelength_nm", nm}, {"n", n.real()}, {"k", n.imag()}});
        values += fmt::format("{:g} nm: n = {:.6g}, k = {:.6g}\n", nm, n.real(), n.imag());
    }
    if (session.json) {
        const ordered_json result = {{"key", medium.key},
                                     {"name", medium.name},
                                     {"formula", medium.formula},
                                     {"tags", medium.tags},
                                     {"range_nm", range_json(medium)},
                                     {"references", medium.references},
                                     {"comments", medium.comments},
                                     {"at", std::move(at)}};
        write_text_output("", result.dump(2) + "\n");
        return kExitOk;
    }
    std::string text =
        fmt::format("{}: {}\nrange: {}\n", medium.key, medium.name, range_text(medium));
    if (!medium.formula.empty()) text += fmt::format("formula: {}\n", medium.formula);
    if (!medium.tags.empty()) text += fmt::format("tags: {}\n", fmt::join(medium.tags, ", "));
    if (!medium.references.empty()) text += fmt::format("references: {}\n", medium.references);
    if (!medium.comments.empty()) text += fmt::format("comments: {}\n", medium.comments);
    write_text_output("", text + values);
    return kExitOk;
}

/// @throws InputError with what is wrong with a file of optical constants or a template
void check_file(const std::string& file)
{
    const std::string extension = std::filesystem::path(file).extension().string();
    if (extension == ".yml" || extension == ".yaml") {
        (void)spectral::parse_refractiveindex_yaml(read_text(file), file);
    } else if (extension == ".toml" || extension == ".json") {
        const material::MaterialTemplate source = read_template_input(file);
        // Looks up the media; only gratings and glasses are quick enough to compile for it.
        if (std::holds_alternative<material::StackSpec>(source.kind))
            (void)pipeline::film_request(source, {});
        else
            (void)pipeline::compile(source, {});
    } else {
        throw InputError(
            {file, 0, "", "must be optical constants (.yml) or a template (.toml, .json)"});
    }
}

int check_files(const Session& session, const LibraryOptions& options)
{
    DiagnosticList problems;
    for (const std::string& file : options.files) {
        try {
            check_file(file);
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

void add_list(CLI::App& library, Session& session, const std::shared_ptr<LibraryOptions>& options)
{
    CLI::App* list = library.add_subcommand("list", "what is built in, with names and ranges");
    list->fallthrough()->footer(
        "\n  nacre library list iron\n  nacre library list --tag metal\n  nacre library list "
        "--kind templates");
    list->add_option("FILTER", options->filter,
                     "part of a key, a name, a formula, a tag or a citation");
    list->add_option("--tag", options->tag, "only media of this tag, e.g. metal, oxide, glass");
    list->add_option("--kind", options->kind)
        ->check(CLI::IsMember({"media", "illuminants", "spaces", "templates"}))
        ->capture_default_str();
    list->callback([&session, options] {
        session.run = [&session, options] { return list_library(session, *options); };
    });
}

}  // namespace

void add_library(CLI::App& app, Session& session)
{
    const auto options = std::make_shared<LibraryOptions>();
    CLI::App* library = app.add_subcommand("library", "optical constants, illuminants, templates");
    library->fallthrough()->require_subcommand(1);
    add_list(*library, session, options);

    CLI::App* show = library->add_subcommand("show", "range, citation and values of a medium");
    show->fallthrough()->footer("\n  nacre library show Fe/Johnson --at 550 --at 633 --json");
    show->add_option("KEY", options->key, "as nacre library list prints it")->required();
    show->add_option("--at", options->wavelengths_nm, "wavelength in nm; may be repeated")
        ->type_name("NM")
        ->expected(1)
        ->take_all();
    show->callback([&session, options] {
        session.run = [&session, options] { return show_medium(session, *options); };
    });

    CLI::App* check = library->add_subcommand("check", "validates optical constants and templates");
    check->fallthrough()->footer("\n  nacre library check my_glass.yml my_film.toml");
    check
        ->add_option("FILE", options->files,
                     "refractiveindex.info YAML (.yml), template (.toml, .json)")
        ->required();
    check->callback([&session, options] {
        session.run = [&session, options] { return check_files(session, *options); };
    });

    CLI::App* schema = library->add_subcommand("schema", "JSON Schema of templates, for editors");
    schema->fallthrough();
    schema->callback([&session] {
        session.run = [] {
            write_text_output("", material::template_json_schema());
            return kExitOk;
        };
    });
}

}  // namespace nacre::tool
