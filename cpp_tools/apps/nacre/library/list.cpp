// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "nacre/core/diagnostics.h"
#include "nacre/kinds/shipped.h"
#include "nacre/library/library_search.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/library/user_library.h"
#include "nacre/media/optical_constants.h"
#include "nacre/spectral/colour.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::EntryKind;
using spectral::Medium;
using spectral::NamedSpectrum;

struct ListOptions {
    std::string filter, tag, kind = "media";
};

/// What a search found, as JSON and as text.
struct Listing {
    ordered_json list = ordered_json::array();
    std::string text;
    DiagnosticList problems;  ///< of a user's own files; the others are listed all the same
};

/// Searches without regard to case.
bool matches(const std::string& text, const std::string& filter)
{
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return std::search(text.begin(), text.end(), filter.begin(), filter.end(), same) != text.end();
}

const char* owner(EntryKind kind, const std::string& key)
{
    return spectral::user_library_file(kind, key) ? "user" : "nacre";
}

void list_medium(const std::string& key, const ListOptions& options, Listing& listing)
{
    const Medium& medium = spectral::library_medium(key);
    if (!spectral::matches(medium, {options.filter, options.tag})) return;
    const auto [first, last] = medium.constants->range_nm();
    const bool bounded = std::isfinite(last);
    listing.list.push_back({{"key", key},
                            {"name", medium.name},
                            {"formula", medium.formula},
                            {"tags", medium.tags},
                            {"range_nm", bounded ? ordered_json{first, last} : ordered_json()},
                            {"library", owner(EntryKind::medium, key)}});
    listing.text += fmt::format(
        "{:<28} {:<20} {}\n", key,
        bounded ? fmt::format("{:g} … {:g} nm", first, last) : "any wavelength", medium.name);
}

void list_spectrum(const std::string& key, const ListOptions& options, Listing& listing)
{
    const NamedSpectrum& spectrum = spectral::library_spectrum(key);
    if (!spectral::matches(spectrum, {options.filter, options.tag})) return;
    const double first = spectrum.samples.first_nm(), last = spectrum.samples.last_nm();
    const auto kind = spectral::spectrum_kind_name(*spectrum.kind);
    listing.list.push_back({{"key", key},
                            {"name", spectrum.name},
                            {"kind", kind},
                            {"tags", spectrum.tags},
                            {"range_nm", {first, last}},
                            {"library", owner(EntryKind::spectrum, key)}});
    listing.text += fmt::format("{:<36} {:<11} {:<14} {}\n", key, kind,
                                fmt::format("{:g} … {:g} nm", first, last), spectrum.name);
}

template <class ListOne>
void list_entries(const std::vector<std::string>& keys, const ListOptions& options,
                  Listing& listing, ListOne&& list_one)
{
    for (const std::string& key : keys) {
        try {
            list_one(key, options, listing);
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics())
                listing.problems.add(diagnostic);
        }
    }
}

void list_names(const std::vector<std::string>& names, const ListOptions& options, Listing& listing)
{
    for (const std::string& name : names) {
        if (!matches(name, options.filter)) continue;
        listing.list.push_back({{"key", name}});
        listing.text += name + "\n";
    }
}

int list_library(const Session& session, const ListOptions& options)
{
    Listing listing;
    if (options.kind == "media")
        list_entries(spectral::library_keys(), options, listing, list_medium);
    else if (options.kind == "spectra")
        list_entries(spectral::library_spectrum_keys(), options, listing, list_spectrum);
    else if (options.kind == "illuminants")
        list_names(spectral::illuminant_names(), options, listing);
    else if (options.kind == "spaces")
        list_names(spectral::colour_space_names(), options, listing);
    else
        list_names(kinds::shipped_ids(), options, listing);
    write_text_output("", session.json ? listing.list.dump(2) + "\n" : listing.text);
    listing.problems.throw_if_any();
    return kExitOk;
}

}  // namespace

void add_library_list(CLI::App& library, Session& session)
{
    const auto options = std::make_shared<ListOptions>();
    CLI::App* list = library.add_subcommand("list", "what is there, with names and ranges");
    list->fallthrough()->footer(
        "\n  nacre library list iron\n  nacre library list --tag metal\n  nacre library list "
        "--kind spectra sodium\n  nacre library list --kind templates");
    list->add_option("FILTER", options->filter,
                     "part of a key, a name, a formula, a tag or a citation");
    list->add_option("--tag", options->tag,
                     "only media or spectra of this tag, e.g. metal, oxide, led");
    list->add_option("--kind", options->kind)
        ->check(CLI::IsMember({"media", "spectra", "illuminants", "spaces", "templates"}))
        ->capture_default_str();
    list->callback([&session, options] {
        session.run = [&session, options] { return list_library(session, *options); };
    });
}

}  // namespace nacre::tool
