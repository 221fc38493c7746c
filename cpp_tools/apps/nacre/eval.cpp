// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "eval.h"

#include <cstdio>
#include <memory>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>

#include "held_ends.h"
#include "output.h"
#include "session.h"

namespace nacre::tool {
namespace {

struct EvalOptions {
    std::string input = "-", output;
    ColourTargetOptions colour;
    std::string adaptation = "bradford", gamut = "keep", range = "none", sampling = "adaptive";
    bool strict_range = false;
};

constexpr const char* kStackHelp = R"(
record  {"n": [[re, im], …], "d_nm": […], "angle_deg": 30, "wavelength_nm": 550,
         "pol": "s|p|u", "coherence": ["i", "c", …], "spread_nm": […], "bandwidth_nm": 0,
         "layers": false}
  n              indices from the ambient to the substrate, [n, k] or n alone: n > 0, k ≥ 0, and
                 k = 0 in the ambient
  d_nm           thickness of the 0 … 64 layers between, ≥ 0
  angle_deg      angle of incidence in the ambient, in [0, 90) (default 0)
  pol            s, p, or u for the mean of both (default u)
  coherence      optional: "c" or "i" a layer (default c); or, as in the tmm package, a medium,
                 with "i" at both ends
  spread_nm      optional: standard deviation of each thickness within what is looked at
  bandwidth_nm   optional: Gaussian band of the light, full width at half maximum
  layers         optional: true adds what each layer absorbs, without spread and bandwidth only
result  {"R": …, "T": …, "A": …, "r": [re, im], "t": [re, im], "A_layers": […]}; r and t are null
        for u and where a layer is incoherent or averaged over

Bare glass reflects 4 %:
  echo '{"n": [1, 1.5], "d_nm": [], "wavelength_nm": 550}' | nacre eval stack
Silver between two glasses, and how much of the light it keeps:
  echo '{"n": [1, 1.52, [0.05, 3.3], 1.52], "d_nm": [1e6, 20], "coherence": ["i", "c"],
         "angle_deg": 45, "wavelength_nm": 550, "pol": "u", "layers": true}' | nacre eval stack
A file with an array of records, in the same order out:
  nacre eval stack stacks.json -o results.json)";

constexpr const char* kSpectrumHelp = R"(
record  {"wavelength_nm": […], "values": […], "kind": "emission|reflectance",
         "illuminant": "D65", "observer": "cie1931|cie1964"}
        {"spectrum": "study/box", "kind": "reflectance", "scale": 1, "illuminant": "lamp/hps"}
        {"illuminant": "D50"}, {"blackbody_K": 2856} or {"daylight_K": 6504}, with "observer" or not
        {"rgb": [r, g, b], "method": "jakob-hanika|smits", "kind": "reflectance|emission",
         "wavelength_nm": […], "illuminant": "D65", "observer": "cie1931|cie1964"}
  wavelength_nm  ascending. To 1 nm: by Sprague where six or more stand in equal steps (CIE 167),
                 else linearly; outside of them the nearest value counts (CIE 015:2018, 7.2.3)
  spectrum       key of nacre library list --kind spectra; kind takes it for another than it was
                 measured as, such as the shape of a light for that of a paint; scale multiplies it
  illuminant     of a reflectance (default D65): a name of `nacre library list --kind illuminants`,
                 blackbody:3200, daylight:5600, line:589.3 or line:435.8@1,546.1@0.8 (power after @)
  observer       default cie1931
  rgb            linear, of the space of the answer: a spectrum that has this colour under D65 and
                 cie1931, a light with kind emission; then also "wavelength_nm", "values",
                 "error_dE00" of the round trip and, by jakob-hanika, "coefficients" by nm: the
                 values are 1/2 + x/(2√(1 + x²)), x their polynomial, for a light times 2 max(rgb)
                 times D65 of Y = 1
  method         jakob-hanika (default) meets every colour of Rec.709 with values in [0, 1];
                 smits is off by some hundredths
  wavelength_nm  with rgb: where values are wanted, default 380, 390 … 780
result  {"XYZ": […], "xy": […], "Lab": […], "rgb": […], "space": "…", "cct_K": …, "duv": …}
        emission is normalised with k = 1/∫ȳ dλ, reflectance with k = 1/∫Sȳ dλ; illuminants, whose
        tables are relative, to Y = 1. Lab and rgb of a reflectance are those of a perfect white
        adapted to (100, 0, 0) and (1, 1, 1); Lab of an emission is relative to D65 with Y = 1.
        cct_K and duv are null where a colour has no correlated colour temperature.

The white point of D50:
  echo '{"illuminant": "D50"}' | nacre eval spectrum
Two lines of mercury:
  echo '{"illuminant": "line:435.8@1,546.1@0.8"}' | nacre eval spectrum
A smooth reflectance for an orange:
  echo '{"rgb": [0.8, 0.3, 0.02]}' | nacre eval spectrum
In a space of an OpenColorIO config:
  nacre eval spectrum chips.json --config config.ocio --space ACEScg)";

constexpr const char* kColourHelp = R"(
record  {"n": ["air", "water/Daimon-20C", 1], "d_nm": [400], "angle_deg": 30, "pol": "u",
         "coherence": ["c"], "illuminant": "D65", "observer": "cie1931"}
  n              media from the ambient to the substrate: keys of `nacre library list`, n, or [n, k]
  d_nm           thickness of the 0 … 64 layers between, ≥ 0
  angle_deg      angle of incidence in the ambient, in [0, 90) (default 0)
  the rest       optional: pol s, p or u (default u); coherence as for `nacre eval stack`;
                 illuminant and observer as for `nacre eval spectrum`
result  {"reflectance": {"XYZ": […], "Lab": […], "rgb": […]}, "transmittance": {…}, "space": "…",
         "wavelengths": 11}; wavelengths: at how many the stack was computed. "held_ends" lists
         media whose data end within 360 … 830 nm and that are held there, with their share of the
         luminous weight

--sampling adaptive takes as many wavelengths as amplitudes need to be interpolated, loses no line
however narrow, and is within 0.001 of `reference`, every 0.05 nm. `full` is every nanometre; steps:N
and hierarchical:LEVEL are there to be compared with.

A soap film of 400 nm:
  echo '{"n": [1, "water/Daimon-20C", 1], "d_nm": [400], "angle_deg": 30}' | nacre eval colour
What eight samples make of it:
  echo '{"n": [1, "water/Daimon-20C", 1], "d_nm": [400], "angle_deg": 30}' |
    nacre eval colour --sampling hierarchical:6)";

constexpr const char* kGratingHelp = R"(
record  {"pitch_nm": 1600, "grating_vector": [x, y, z], "normal": [x, y, z], "k_in": [x, y, z],
         "wavelength_nm": 550, "orders": [-3, 3],
         "profile": {"kind": "sinusoidal|rectangular|blazed", "phase_rad": 1.5, "duty": 0.5}}
  grating_vector across the grooves; only its part in the surface counts
  k_in           direction of the light, towards the surface; its length does not matter
  profile        what shares the light among the orders: without it the answer is directions alone
  phase_rad      from peak to valley, of the reflected light
  duty           in (0, 1), of a rectangular profile (default 0.5)
result  {"orders": [{"order": m, "direction": [x, y, z], "efficiency": …}, …]}; the direction of an
        evanescent order is null; efficiency, with a profile only, is a share of the reflected light

A CD under a light from above:
  echo '{"pitch_nm": 1600, "grating_vector": [1,0,0], "normal": [0,0,1], "k_in": [0,0,-1],
         "wavelength_nm": 550, "orders": [-3, 3],
         "profile": {"kind": "rectangular", "phase_rad": 1.5}}' | nacre eval grating)";

constexpr const char* kFilmHelp = R"(
record  {"model": "airy", "n": [1, 1.33, 1], "d_nm": [400], "angle_deg": 30,
         "wavelength_nm": 550, "pol": "s|p|u"}
  model          airy             clear film on a clear base (Durikovic and Kimura); exact
                 series           reflection at the top and two round trips, cut there
                 opaque_base      clear film on a base that may absorb (Sun and Wang); exact
                 free_film        the same medium on both sides, such as a soap bubble; exact
                 etalon           Airy's function; "mirror_reflectance": R instead of Fresnel's
                 recursion        any absorbing layers, from the base up (Hirayama); exact
                 path_difference  bands without physics; "view_angle_deg" instead of "pol"
                 uv               interface alone by u + iv = cosθ₂; "n" of two media, "d_nm": []
  the rest       as for `nacre eval stack`; film and ambient are clear, and no form but recursion
                 and uv has total reflection
result  {"R": …, "exact": …, "error": …}: the form, the multilayer, and their difference; null where
        the mirrors are given. path_difference: {"bands": …} in [0, 1). uv: {"R": …,
        "r_s": [re, im], "r_p": [re, im], "cos": [u, v]}

How far the cut series is off on a high index:
  echo '{"model": "series", "n": [1, 2.4, 3.5], "d_nm": [115], "angle_deg": 0,
         "wavelength_nm": 550, "pol": "u"}' | nacre eval film)";

constexpr const char* kSlitsHelp = R"(
record  {"width_nm": 2000, "spacing_nm": 6000, "angle_deg": 5, "wavelength_nm": 550}
  spacing_nm     between the centres of two slits, at least their width; without it one slit
  angle_deg      away from straight ahead, in [-90, 90] (default 0)
result  {"intensity": …}, far behind the slits, 1 straight ahead

The first dark fringe of two slits:
  echo '{"width_nm": 1000, "spacing_nm": 4000, "angle_deg": 3.94, "wavelength_nm": 550}' |
    nacre eval slits)";

std::string joined(const InputError& error)
{
    std::vector<std::string> texts;
    for (const Diagnostic& diagnostic : error.diagnostics()) texts.push_back(diagnostic.text());
    return fmt::format("{}", fmt::join(texts, "; "));
}

/// Answers of a batch, and which of them are errors.
struct Answers {
    std::vector<ordered_json> records;
    std::vector<std::unique_ptr<InputError>> errors;
};

Answers answer_all(const json& batch, const RecordEvaluator& evaluate)
{
    Answers answers;
    answers.records.resize(batch.size());
    answers.errors.resize(batch.size());
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) {
        try {
            answers.records[i] = evaluate(batch[i]);
        } catch (const InputError& error) {
            answers.records[i] = {{"error", joined(error)}};
            answers.errors[i] = std::make_unique<InputError>(error);
        }
    });
    return answers;
}

std::string batch_text(const std::vector<ordered_json>& records)
{
    std::string text = "[";
    for (std::size_t i = 0; i < records.size(); ++i)
        text += (i == 0 ? "\n" : ",\n") + records[i].dump();
    return text + "\n]\n";
}

/// Each note once, however many records have it.
void note_held(const Session& session, const std::vector<ordered_json>& records)
{
    std::set<std::string> said;
    for (const ordered_json& record : records)
        for (const ordered_json& ends : record.value("held_ends", ordered_json::array()))
            if (const auto note = ends["note"].get<std::string>(); said.insert(note).second)
                session.note(note);
}

/// --range, over the rgb of all records that have one.
void map_range(std::vector<ordered_json>& records, const std::string& range)
{
    std::vector<ordered_json*> places;
    std::vector<spectral::Vec3> colours;
    const auto add = [&](ordered_json& holder) {
        const auto rgb = holder.find("rgb");
        if (rgb == holder.end()) return;
        places.push_back(&*rgb);
        colours.push_back(rgb->get<spectral::Vec3>());
    };
    for (ordered_json& record : records) {
        add(record);
        for (const char* part : {"reflectance", "transmittance"})
            if (record.contains(part)) add(record[part]);
    }
    map_range(colours, spectral::range_mapping_from_name(range));
    for (std::size_t i = 0; i < places.size(); ++i) *places[i] = colours[i];
}

void report(const Session& session, const std::string& file, const JsonDocument& document,
            const Answers& answers)
{
    for (std::size_t i = 0; i < answers.errors.size(); ++i) {
        if (!answers.errors[i]) continue;
        const bool is_batch = document.value.is_array();
        for (Diagnostic diagnostic : answers.errors[i]->diagnostics()) {
            diagnostic.file = file;
            if (is_batch) {
                diagnostic.line = document.record_lines[i];
                diagnostic.field = diagnostic.field.empty()
                                       ? fmt::format("[{}]", i)
                                       : fmt::format("[{}].{}", i, diagnostic.field);
            }
            session.error(diagnostic.text());
        }
    }
}

int evaluate_file(const Session& session, const EvalOptions& options,
                  const RecordEvaluator& evaluate)
{
    const JsonDocument document = parse_json(read_input(options.input), options.input);
    const bool is_batch = document.value.is_array();
    if (!is_batch && !document.value.is_object())
        throw InputError({options.input, 0, "",
                          fmt::format("must be one record {{…}} or an array of records (got {})",
                                      quoted(document.value))});
    Answers answers =
        answer_all(is_batch ? document.value : json::array({document.value}), evaluate);
    if (options.range != "none") map_range(answers.records, options.range);
    write_text_output(options.output, is_batch ? batch_text(answers.records)
                                               : answers.records.front().dump() + "\n");
    note_held(session, answers.records);
    report(session, options.input, document, answers);
    const auto failed = [](const auto& error) { return error != nullptr; };
    return std::any_of(answers.errors.begin(), answers.errors.end(), failed) ? kExitInputError
                                                                             : kExitOk;
}

CLI::App* add_kind(CLI::App& eval, const char* name, const char* description, const char* help,
                   const std::shared_ptr<EvalOptions>& options)
{
    CLI::App* kind = eval.add_subcommand(name, description)->fallthrough()->footer(help);
    kind->add_option("FILE", options->input,
                     "JSON record or array of records; - is the standard input")
        ->capture_default_str();
    kind->add_option("-o,--output", options->output, "where to write (default: standard output)");
    return kind;
}

ColourChoices resolve_choices(const EvalOptions& options, const ColourTarget& target)
{
    ColourChoices choices{.adaptation = spectral::adaptation_from_name(options.adaptation),
                          .gamut = spectral::gamut_mapping_from_name(options.gamut),
                          .sampling = options.sampling,
                          .range = range_rule(options.strict_range)};
    // So that a wrong name is one error, not one for each record.
    (void)named_quadrature(choices.sampling, spectral::ColourWeights{});
    if (choices.gamut == spectral::GamutMapping::desaturate) (void)linear_space(target);
    const bool rgb = !target.linear || target.linear->chromaticities;
    if (choices.gamut != spectral::GamutMapping::keep && !rgb)
        throw InputError({"", 0, "--gamut",
                          fmt::format("must be keep in a space that is not RGB, {} (got {})",
                                      target.name, options.gamut)});
    return choices;
}

using ColourEvaluator = ordered_json (*)(const json& record, const ColourTarget& target,
                                         const ColourChoices& choices);

void add_colours(CLI::App& kind, Session& session, const std::shared_ptr<EvalOptions>& options,
                 ColourEvaluator evaluate)
{
    add_colour_target_options(kind, options->colour);
    add_adaptation_option(kind, options->adaptation);
    kind.add_option("--gamut", options->gamut,
                    "rgb outside [0, 1]: keep; clip each channel; desaturate towards the grey of "
                    "the same luminance, a light only until no channel is negative; scale all "
                    "channels by one factor")
        ->check(CLI::IsMember({"keep", "clip", "desaturate", "scale"}))
        ->capture_default_str();
    kind.add_option("--range", options->range,
                    "rgb of all records together: none; clamp to [0, 1]; normalise by the largest "
                    "channel of all")
        ->check(CLI::IsMember({"none", "clamp", "normalise"}))
        ->capture_default_str();
    kind.add_option("--sampling", options->sampling,
                    "adaptive, full (1 nm), reference (0.05 nm), steps:1 … steps:128 (nm), "
                    "hierarchical:0 … hierarchical:9 (level)")
        ->capture_default_str();
    kind.callback([&session, options, evaluate] {
        session.run = [&session, options, evaluate] {
            const ColourTarget target = resolve_colour_target(options->colour);
            const ColourChoices choices = resolve_choices(*options, target);
            return evaluate_file(session, *options, [&](const json& record) {
                return evaluate(record, target, choices);
            });
        };
    });
}

}  // namespace

void add_eval(CLI::App& app, Session& session)
{
    CLI::App* eval = app.add_subcommand("eval", "numbers without pictures: JSON in, JSON out");
    eval->fallthrough()->require_subcommand(1)->footer(R"(
A record, or an array of records, comes from a file or the standard input; -o FILE takes the answers.

  echo '{"blackbody_K": 2856}' | nacre eval spectrum
  nacre eval stack stack.json -o results.json)");
    const auto options = std::make_shared<EvalOptions>();

    add_kind(*eval, "stack", "R, T, A, r, t of a multilayer at one angle and wavelength",
             kStackHelp, options)
        ->callback([&session, options] {
            session.run = [&session, options] {
                return evaluate_file(session, *options, evaluate_stack);
            };
        });
    add_kind(*eval, "film", "closed forms of one film beside the exact value", kFilmHelp, options)
        ->callback([&session, options] {
            session.run = [&session, options] {
                return evaluate_file(session, *options, evaluate_film);
            };
        });
    add_kind(*eval, "slits", "intensity behind one slit or two", kSlitsHelp, options)
        ->callback([&session, options] {
            session.run = [&session, options] {
                return evaluate_file(session, *options, evaluate_slits);
            };
        });
    add_kind(*eval, "grating", "directions and efficiencies of diffraction orders", kGratingHelp,
             options)
        ->callback([&session, options] {
            session.run = [&session, options] {
                return evaluate_file(session, *options, evaluate_grating);
            };
        });
    add_colours(*add_kind(*eval, "spectrum", "colour and colour temperature of a spectrum",
                          kSpectrumHelp, options),
                session, options, evaluate_spectrum);
    CLI::App* colour =
        add_kind(*eval, "colour", "colour of a multilayer at one angle", kColourHelp, options);
    add_colours(*colour, session, options, evaluate_colour);
    add_strict_range(*colour, options->strict_range);
}

}  // namespace nacre::tool
