// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/library/user_library.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::EntryKind;
using spectral::NamedSpectrum;
using spectral::SpectrumKind;
using spectral::UserEntry;

struct ImportOptions {
    std::vector<std::string> files;
    std::string key, kind, citation, licence;
    std::optional<double> scale;
    bool replace = false;
    bool alone = true;  ///< one source, whose key may be given
};

/// What was put right or is otherwise than a file has it, each with its file.
using Changes = std::vector<std::string>;

/// One file, or two of one medium.
struct Source {
    std::string file;
    std::string k_file;  ///< of a pair of pbrt's; `file` then has n
};

/// A name as one part of a key: what keys do not have becomes a hyphen.
std::string key_part(const std::string& name)
{
    std::string part;
    for (const char c : name) {
        const bool good = spectral::is_library_key(std::string("a") + c) && c != '/';
        if (good)
            part += c;
        else if (!part.empty() && part.back() != '-')
            part += '-';
    }
    while (!part.empty() && part.back() == '-') part.pop_back();
    part.erase(0, std::min(part.find_first_not_of(".-"), part.size()));
    return part;
}

constexpr std::string_view kEta = ".eta.spd", kK = ".k.spd";

/// Files one by one, but for pairs; those have the place of their first.
/// @throws InputError for half a pair
std::vector<Source> sources_of(const ImportOptions& options)
{
    std::vector<Source> sources;
    DiagnosticList problems;
    const auto given = [&options](const std::string& file) {
        return std::ranges::find(options.files, file) != options.files.end();
    };
    // A spectrum may be called so, too, where --kind tells that it is one.
    const bool pairs = options.kind.empty() || options.kind == "medium";
    for (const std::string& file : options.files) {
        const bool n = pairs && file.ends_with(kEta), k = pairs && file.ends_with(kK);
        if (!n && !k) {
            sources.push_back({file, {}});
            continue;
        }
        const std::string stem = file.substr(0, file.size() - (n ? kEta : kK).size());
        const Source pair = {fmt::format("{}{}", stem, kEta), fmt::format("{}{}", stem, kK)};
        const auto same = [&pair](const Source& source) { return source.k_file == pair.k_file; };
        if (const std::string& other = n ? pair.k_file : pair.file; !given(other))
            problems.add({file, 0, {}, "must come with " + other + ", n and k of one medium"});
        else if (std::ranges::none_of(sources, same))
            sources.push_back(pair);
    }
    problems.throw_if_any();
    return sources;
}

/// `--as KEY` is the key of one file, or the folder of several; without it the folder is `user`.
std::string key_of_file(const ImportOptions& options, const std::string& file)
{
    if (!options.key.empty() && options.alone) return options.key;
    const std::string part = key_part(std::filesystem::path(file).stem().string());
    return fmt::format("{}/{}", options.key.empty() ? "user" : options.key,
                       part.empty() ? "entry" : part);
}

UserEntry read_medium(const ImportOptions& options, const std::string& file, Changes& changes)
{
    std::vector<std::string> made;
    UserEntry entry{
        EntryKind::medium, key_of_file(options, file),
        spectral::refractiveindex_yaml_of_file(read_text(file), file, options.citation, made)};
    for (const std::string& change : made) changes.push_back(fmt::format("{}: {}", file, change));
    return entry;
}

NamedSpectrum completed(NamedSpectrum spectrum, const ImportOptions& options,
                        const std::string& file)
{
    if (!spectrum.kind)
        throw InputError(
            {file, 0, "--kind", "must be emission or reflectance: the file does not tell"});
    if (!options.citation.empty()) spectrum.references = options.citation;
    if (!options.licence.empty()) spectrum.licence = options.licence;
    if (auto problem = spectral::kind_problem(spectrum.samples, *spectrum.kind))
        throw InputError({file, 0, spectrum.name,
                          *problem + "; --scale multiplies the values, by 0.01 for per cent"});
    return spectrum;
}

std::vector<UserEntry> read_spectra(const ImportOptions& options, const std::string& file,
                                    Changes& changes)
{
    std::vector<NamedSpectrum> spectra =
        read_spectra_file(file, {}, read_as(options.kind, options.scale));
    if (auto note = override_note(file, spectra)) changes.push_back(std::move(*note));
    const std::string folder = key_of_file(options, file);
    std::vector<UserEntry> entries;
    std::set<std::string> parts;
    DiagnosticList problems;
    for (NamedSpectrum& spectrum : spectra) {
        std::string key = folder;
        if (spectra.size() > 1) {
            std::string part = key_part(spectrum.name);
            // Patches without a name, or of one name: by their number.
            if (part.empty() || !parts.insert(part).second)
                part = fmt::format("{}{}{}", part, part.empty() ? "" : "-", entries.size() + 1);
            key += "/" + part;
        }
        try {
            const NamedSpectrum whole = completed(std::move(spectrum), options, file);
            entries.push_back({EntryKind::spectrum, key, write_library_spectrum(whole)});
        } catch (const InputError& error) {
            for (Diagnostic diagnostic : error.diagnostics()) {
                diagnostic.file = file;
                problems.add(std::move(diagnostic));
            }
        }
    }
    problems.throw_if_any();
    return entries;
}

UserEntry read_pair(const ImportOptions& options, const Source& pair, Changes& changes)
{
    std::string text = spectral::refractiveindex_yaml_from_spd(read_text(pair.file), pair.file,
                                                               read_text(pair.k_file), pair.k_file,
                                                               options.citation, changes);
    const std::string metal = pair.k_file.substr(0, pair.k_file.size() - kK.size());
    return {EntryKind::medium, key_of_file(options, metal + ".spd"), std::move(text)};
}

std::vector<UserEntry> read_source(const ImportOptions& options, const Source& source,
                                   Changes& changes)
{
    if (!source.k_file.empty()) return {read_pair(options, source, changes)};
    const std::string& file = source.file;
    const std::string extension = std::filesystem::path(file).extension().string();
    const bool yaml = extension == ".yml" || extension == ".yaml";
    if (yaml && !options.kind.empty() && options.kind != "medium")
        throw InputError({file, 0, "--kind", "must be medium for optical constants"});
    if (options.kind == "medium" && is_texture_file(file))
        throw InputError(
            {file, 0, "--kind",
             "must be emission or reflectance for an image; optical constants are read "
             "from .yml, .csv or a pair of .spd"});
    if (yaml || options.kind == "medium") return {read_medium(options, file, changes)};
    return read_spectra(options, file, changes);
}

int import_files(const Session& session, ImportOptions options)
{
    std::vector<UserEntry> entries;
    DiagnosticList problems;
    Changes changes;
    const std::vector<Source> sources = sources_of(options);
    options.alone = sources.size() == 1;
    for (const Source& source : sources) {
        try {
            for (UserEntry& entry : read_source(options, source, changes))
                entries.push_back(std::move(entry));
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        }
    }
    problems.throw_if_any();
    const auto files = spectral::save_user_entries(entries, options.replace);
    for (const std::string& change : changes) session.note("changed: " + change);
    ordered_json list = ordered_json::array();
    std::string text;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const bool medium = entries[i].kind == EntryKind::medium;
        list.push_back({{"key", entries[i].key},
                        {"kind", medium ? "medium" : "spectrum"},
                        {"file", files[i].string()}});
        text += fmt::format("{:<28} {}\n", entries[i].key, files[i].string());
    }
    write_text_output("", session.json ? list.dump(2) + "\n" : text);
    return kExitOk;
}

constexpr const char* kLibraryImportHelp = R"(
A table (.csv, text) is a column of wavelengths and one for each spectrum, or n and k with --kind
medium, in UTF-8 or UTF-16:
  between cells  tabs, ; , or spaces
  numbers        with points; with commas where no comma is between cells, or in quotes
  wavelengths    ascending or descending; called wavelength, lambda, λ, WL or Wellenlänge, a unit, or
                 both, whatever the case: wavelength_nm, Wavelength(nm), λ (nm), λ / µm, lambda_nm, nm
  units          nm, also where none is named; µm (um, micron); Å. wl alone is µm below 100
  per cent       columns called R (%), R [%], %T, R percent, r_pct: they become ratios
  no first row   of names: then nanometres
Lines of # are comments; at the top # KEY: value with NAME, KIND, REFERENCES, LICENCE, COMMENTS, TAGS.

  nacre library import my_glass.yml --as glass/mine
  nacre library import lamp.spdx --citation "data sheet of the maker"
  nacre library import chart.cgats --kind reflectance --as chart
  nacre library import film.csv --kind medium
  nacre library import Au.eta.spd Au.k.spd)";

}  // namespace

void add_library_import(CLI::App& library, Session& session)
{
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        library.add_subcommand("import", "optical constants and spectra into your own library");
    command->fallthrough()->footer(kLibraryImportHelp);
    command
        ->add_option("FILE", options->files,
                     "refractiveindex.info YAML (.yml), .csv, .spd, IES TM-27-14 (.spdx), CGATS, "
                     "spectral .exr, textures of spectra")
        ->required();
    command->add_option(
        "--as", options->key,
        "key of the entry, or folder of several; by default user/<name of the file>");
    command
        ->add_option("--kind", options->kind,
                     "what the values are, where the file does not tell; in place of what it "
                     "states with a note, and not where its values cannot be of that kind")
        ->check(CLI::IsMember({"medium", "reflectance", "emission"}));
    command->add_option("--citation", options->citation, "where the data are from");
    command->add_option("--licence", options->licence, "on what terms they may be used");
    command->add_option("--scale", options->scale, kScaleHelp);
    command->add_flag("--replace", options->replace,
                      "take the place of your own entry of that key");
    command->callback([&session, options] {
        session.run = [&session, options] { return import_files(session, *options); };
    });
}

}  // namespace nacre::tool
