// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "bake/ramp.h"
#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/version.h"
#include "nacre/kinds/held_media.h"
#include "nacre/lut/film_table.h"
#include "nacre/pipeline/compile.h"
#include "shared/held_ends.h"
#include "shared/session.h"
#include "tables/options.h"

namespace nacre::tool {
namespace {

struct BakeOptions {
    std::string input, output;
    RampOptions ramp;
    TableOptions table;
};

constexpr const char* kBakeRampHelp = R"(
INPUT is a film template (.toml) or the JSON of one, as for nacre bake stack, in which something varies.
The ramp holds exact colours at equal steps of it, at one angle:
  .cube    1-D table of Adobe and DaVinci, its domain in nm (or the factor)
  .spi1d   1-D table of Sony Imageworks, the same
  .csv     thickness_nm,R,G,B under lines that say where it is from

Colours of oxides while steel is tempered, for a colour ramp:
  nacre bake ramp osl/templates/tempered_steel.toml -o tempered_steel.cube
Eight colours of a soap film seen at 45 degrees:
  nacre bake ramp osl/templates/soap_film.toml --angle 45 --size 8 -o soap_film.csv)";

struct Ramp {
    std::string title, name;  ///< of the material; `thickness_nm` or `thickness_scale`
    double min, max, angle_deg;
    std::string quantity, illuminant, observer, adaptation, space;
    std::vector<spectral::HeldEnds> held;
    std::vector<spectral::Vec3> colours;
};

void add_rows(std::string& text, const Ramp& ramp, const char* before, const char* between)
{
    for (const spectral::Vec3& rgb : ramp.colours)
        fmt::format_to(std::back_inserter(text), "{}{:.9g}{}{:.9g}{}{:.9g}\n", before, rgb[0],
                       between, rgb[1], between, rgb[2]);
}

/// What the file holds, each line after `mark`.
std::string provenance(const Ramp& ramp, const char* mark)
{
    std::string text = fmt::format(
        "{0} {1} at {2:g} degrees, along {3} {4:g} ... {5:g}\n"
        "{0} illuminant {6}, observer {7}, adaptation {8}, space {9}; Nacre {10}\n",
        mark, ramp.quantity, ramp.angle_deg, ramp.name, ramp.min, ramp.max, ramp.illuminant,
        ramp.observer, ramp.adaptation, ramp.space, version());
    for (const spectral::HeldEnds& ends : ramp.held)
        text += fmt::format("{} {}\n", mark, ends.note());
    return text;
}

/// The format has no quotes within quotes.
std::string cube_text(const Ramp& ramp)
{
    std::string title = ramp.title;
    std::ranges::replace(title, '"', '\'');
    std::string text = fmt::format("TITLE \"{}\"\n", title) + provenance(ramp, "#");
    text += fmt::format(
        "LUT_1D_SIZE {0}\nDOMAIN_MIN {1:.9g} {1:.9g} {1:.9g}\n"
        "DOMAIN_MAX {2:.9g} {2:.9g} {2:.9g}\n",
        ramp.colours.size(), ramp.min, ramp.max);
    add_rows(text, ramp, "", " ");
    return text;
}

/// The format has no comments.
std::string spi1d_text(const Ramp& ramp)
{
    std::string text = fmt::format("Version 1\nFrom {:.9g} {:.9g}\nLength {}\nComponents 3\n{{\n",
                                   ramp.min, ramp.max, ramp.colours.size());
    add_rows(text, ramp, "    ", " ");
    return text + "}\n";
}

std::string csv_text(const Ramp& ramp)
{
    std::string text = fmt::format("# {}\n", ramp.title) + provenance(ramp, "#");
    text += fmt::format("{},R,G,B\n", ramp.name);
    const double last = static_cast<double>(ramp.colours.size() - 1);
    for (std::size_t i = 0; i < ramp.colours.size(); ++i) {
        const spectral::Vec3& rgb = ramp.colours[i];
        fmt::format_to(std::back_inserter(text), "{:.9g},{:.9g},{:.9g},{:.9g}\n",
                       ramp.min + (ramp.max - ramp.min) * static_cast<double>(i) / last, rgb[0],
                       rgb[1], rgb[2]);
    }
    return text;
}

lut::FilmTableRequest film_request(const kinds::MaterialTemplate& source,
                                   const ResolvedTableOptions& table)
{
    static_cast<void>(kinds::film_of(source, "must be a film: no other kind has a ramp"));
    lut::FilmTableRequest request = kinds::film_request(source, table.compile);
    if (!request.variation)
        throw InputError({source.file, 0, "layer",
                          "must have a thickness that varies, or the stack a scale: a ramp runs "
                          "along it"});
    return request;
}

int bake(const Session& session, const BakeOptions& options)
{
    const RampFormat format = ramp_format(options.output);
    const kinds::MaterialTemplate source = read_template_input(options.input);
    const ResolvedTableOptions table = resolve(options.table);
    check_writable(options.output);
    const std::string text = ramp_text(source, options.ramp, table, format);
    note_held(session, held_media(source, table.compile));
    write_text_output(options.output, text);
    return kExitOk;
}

}  // namespace

RampFormat ramp_format(const std::string& output)
{
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".cube") return RampFormat::cube;
    if (extension == ".spi1d") return RampFormat::spi1d;
    if (extension == ".csv") return RampFormat::csv;
    throw InputError({output, 0, "-o", "must end in .cube, .spi1d or .csv"});
}

std::string ramp_text(const kinds::MaterialTemplate& source, const RampOptions& options,
                      const ResolvedTableOptions& table, RampFormat format)
{
    const lut::FilmTableRequest request = film_request(source, table);
    const double cosine = std::cos(options.angle_deg * std::numbers::pi / 180.0);
    Ramp ramp{.title = source.name,
              .name = request.variation->layer ? "thickness_nm" : "thickness_scale",
              .min = request.variation->min,
              .max = request.variation->max,
              .angle_deg = options.angle_deg,
              .quantity = options.quantity,
              .illuminant = table.provenance.illuminant,
              .observer = std::string(spectral::observer_name(table.provenance.observer)),
              .adaptation = spectral::adaptation_name(table.provenance.adaptation),
              .space = table.provenance.space.name,
              .held = held_media(source, table.compile),
              .colours = {}};
    for (const lut::FilmColour& colour : exact_film_ramp(request, cosine, options.size))
        ramp.colours.push_back(options.quantity == "transmittance" ? colour.transmittance
                                                                   : colour.reflectance);
    if (format == RampFormat::cube) return cube_text(ramp);
    return format == RampFormat::spi1d ? spi1d_text(ramp) : csv_text(ramp);
}

void add_ramp_options(CLI::App& command, RampOptions& options)
{
    command.add_option("--angle", options.angle_deg, "degrees from the normal, in the ambient")
        ->check(CLI::Range(0.0, 89.9))
        ->capture_default_str();
    command.add_option("--size", options.size, "colours")
        ->check(CLI::Range(2, 65536))
        ->capture_default_str();
    command.add_option("--quantity", options.quantity)
        ->check(CLI::IsMember({"reflectance", "transmittance"}))
        ->capture_default_str();
}

void add_bake_ramp(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<BakeOptions>();
    CLI::App* ramp =
        bake_command.add_subcommand("ramp", "colours of a film over thickness at one angle");
    ramp->fallthrough()->footer(kBakeRampHelp);
    ramp->add_option("INPUT", options->input, "template (.toml) or stack (.json, -)")->required();
    ramp->add_option("-o,--output", options->output, ".cube, .spi1d or .csv")->required();
    add_ramp_options(*ramp, options->ramp);
    add_light_options(*ramp, options->table);
    ramp->callback([&session, options] {
        session.run = [&session, options] { return bake(session, *options); };
    });
}

}  // namespace nacre::tool
