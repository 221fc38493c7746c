// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "library/plot.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/media/optical_constants.h"
#include "shared/held_ends.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::Medium;
using spectral::NamedSpectrum;

struct ShowOptions {
    std::string key, kind, plot;
    std::vector<double> wavelengths_nm;
};

/// `word: text` on a line of its own; nothing for an empty text.
std::string line(std::string_view word, const std::string& text)
{
    return text.empty() ? std::string() : fmt::format("{}: {}\n", word, text);
}

int show_medium(const Session& session, const ShowOptions& options)
{
    const Medium& medium = spectral::library_medium(options.key);
    if (!options.plot.empty()) write_plot(options.plot, plot_of(medium));
    ordered_json at = ordered_json::array();
    std::string values;
    for (const double nm : options.wavelengths_nm) {
        const spectral::Complex n = medium.constants->at(nm);
        at.push_back({{"wavelength_nm", nm}, {"n", n.real()}, {"k", n.imag()}});
        values += fmt::format("{:g} nm: n = {:.6g}, k = {:.6g}\n", nm, n.real(), n.imag());
    }
    const auto [first, last] = medium.constants->range_nm();
    const bool bounded = std::isfinite(last);
    const auto held =
        held_ends(medium, spectral::named_illuminant("D65"), spectral::ObserverId::cie1931);
    const auto problem = range_problem(*medium.constants, spectral::RangeRule::hold_ends);
    if (session.json) {
        const ordered_json result = {
            {"key", medium.key},
            {"name", medium.name},
            {"formula", medium.formula},
            {"tags", medium.tags},
            {"range_nm", bounded ? ordered_json{first, last} : ordered_json()},
            {"held_ends", held ? held_json({*held}).front() : ordered_json()},
            {"references", medium.references},
            {"comments", medium.comments},
            {"changes", medium.changes},
            {"at", std::move(at)}};
        write_text_output("", result.dump(2) + "\n");
        return kExitOk;
    }
    write_text_output(
        "", fmt::format("{}: {}\nrange: {}\n", medium.key, medium.name,
                        bounded ? fmt::format("{:g} … {:g} nm", first, last) : "any wavelength") +
                line("in colours", held      ? held->note()
                                   : problem ? "refused: " + *problem
                                             : std::string()) +
                line("formula", medium.formula) +
                line("tags", fmt::format("{}", fmt::join(medium.tags, ", "))) +
                line("references", medium.references) + line("comments", medium.comments) +
                line("changed", fmt::format("{}", fmt::join(medium.changes, "; "))) + values);
    return kExitOk;
}

int show_spectrum(const Session& session, const ShowOptions& options)
{
    const NamedSpectrum& spectrum = spectral::library_spectrum(options.key);
    if (!options.plot.empty()) write_plot(options.plot, plot_of(spectrum));
    ordered_json at = ordered_json::array();
    std::string values;
    for (const double nm : options.wavelengths_nm) {
        const double value = spectrum.samples.at(nm);
        at.push_back({{"wavelength_nm", nm}, {"value", value}});
        values += fmt::format("{:g} nm: {:.6g}\n", nm, value);
    }
    const std::string kind(spectral::spectrum_kind_name(*spectrum.kind));
    const double first = spectrum.samples.first_nm(), last = spectrum.samples.last_nm();
    if (session.json) {
        const ordered_json result = {{"key", spectrum.key},
                                     {"name", spectrum.name},
                                     {"kind", kind},
                                     {"tags", spectrum.tags},
                                     {"range_nm", {first, last}},
                                     {"references", spectrum.references},
                                     {"licence", spectrum.licence},
                                     {"comments", spectrum.comments},
                                     {"wavelength_nm", spectrum.samples.wavelengths_nm()},
                                     {"values", spectrum.samples.values()},
                                     {"at", std::move(at)}};
        write_text_output("", result.dump(2) + "\n");
        return kExitOk;
    }
    write_text_output(
        "", fmt::format("{}: {}\nkind: {}\nrange: {:g} … {:g} nm, {} samples\n", spectrum.key,
                        spectrum.name, kind, first, last, spectrum.samples.values().size()) +
                line("tags", fmt::format("{}", fmt::join(spectrum.tags, ", "))) +
                line("references", spectrum.references) + line("licence", spectrum.licence) +
                line("comments", spectrum.comments) + values);
    return kExitOk;
}

/// Media and spectra have keys of their own; --kind decides where both have one.
int show_entry(const Session& session, const ShowOptions& options)
{
    if (!options.plot.empty()) check_plot_file(options.plot);
    const auto has = [&](const std::vector<std::string>& keys) {
        return std::ranges::find(keys, options.key) != keys.end();
    };
    const bool medium = options.kind != "spectrum" && has(spectral::library_keys());
    const bool spectrum = options.kind != "medium" && has(spectral::library_spectrum_keys());
    if (medium && spectrum)
        throw InputError({.file = {},
                          .field = "--kind",
                          .message = fmt::format("must be medium or spectrum: both have the key {}",
                                                 options.key)});
    if (medium || options.kind == "medium") return show_medium(session, options);
    if (spectrum || options.kind == "spectrum") return show_spectrum(session, options);
    DiagnosticList problems;  // near keys of both
    for (const auto show : {show_medium, show_spectrum}) {
        try {
            return show(session, options);
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics()) problems.add(diagnostic);
        }
    }
    problems.throw_if_any();
    return kExitInputError;
}

}  // namespace

void add_library_show(CLI::App& library, Session& session)
{
    const auto options = std::make_shared<ShowOptions>();
    CLI::App* show =
        library.add_subcommand("show", "range, citation and values of a medium or a spectrum");
    show->fallthrough()->footer(
        "\n  nacre library show Fe/Johnson --at 550 --at 633 --json\n"
        "  nacre library show colorchecker/dark-skin --plot dark-skin.svg");
    show->add_option("KEY", options->key, "as nacre library list prints it")->required();
    show->add_option("--at", options->wavelengths_nm, "wavelength in nm; may be repeated")
        ->type_name("NM")
        ->expected(1)
        ->allow_extra_args(false)
        ->take_all();
    show->add_option("--kind", options->kind, "medium or spectrum, where both have the key")
        ->check(CLI::IsMember({"medium", "spectrum"}));
    show->add_option("--plot", options->plot, "a picture of it, too: .svg or .png")
        ->type_name("FILE");
    show->callback([&session, options] {
        session.run = [&session, options] { return show_entry(session, *options); };
    });
}

}  // namespace nacre::tool
