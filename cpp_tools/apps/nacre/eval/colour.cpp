// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "eval/colours.h"
#include "eval/questions.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/optics/film_stack.h"
#include "nacre/optics/stack_colour.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/colour_quadrature.h"
#include "shared/held_ends.h"

namespace nacre::tool {
namespace {

using spectral::OpticalConstantsPtr;
using spectral::Vec3;

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

/// A key of the library, n, or [n, k]; null where it is wrong.
OpticalConstantsPtr read_medium(const json& value, const std::string& field,
                                spectral::WorkingRange& range, DiagnosticList& problems)
{
    try {
        if (value.is_string())
            return range.cover(
                spectral::library_medium(value.get_ref<const std::string&>()).constants);
    } catch (const InputError& error) {
        for (const Diagnostic& problem : error.diagnostics())
            problems.add({"", 0, field, problem.message});
        return nullptr;
    }
    if (value.is_number()) return read_medium(json::array({value, 0.0}), field, range, problems);
    if (!value.is_array() || value.size() != 2) {
        problems.add(
            {"", 0, field,
             fmt::format("must be a key of the library, n or [n, k] (got {})", quoted(value))});
        return nullptr;
    }
    const auto n = read_number(value[0], field + "[0]", kPositive, problems);
    const auto k = read_number(value[1], field + "[1]", kNotNegative, problems);
    return n && k ? spectral::constant_index({*n, *k}) : nullptr;
}

std::vector<OpticalConstantsPtr> read_media(ObjectReader& reader, spectral::RangeRule rule,
                                            DiagnosticList& problems)
{
    const json* list = reader.required("n");
    if (!list) return {};
    if (!list->is_array() || list->size() < 2 || list->size() > optics::kMaxLayers + 2) {
        reader.problem(
            "n", fmt::format("must list 2 … {} media, ambient and substrate and at most "
                             "{} layers (got {})",
                             optics::kMaxLayers + 2, optics::kMaxLayers,
                             list->is_array() ? fmt::format("{}", list->size()) : quoted(*list)));
        return {};
    }
    spectral::WorkingRange range(rule);
    std::vector<OpticalConstantsPtr> media;
    media.reserve(list->size());
    for (std::size_t i = 0; i < list->size(); ++i)
        media.push_back(read_medium((*list)[i], fmt::format("n[{}]", i), range, problems));
    return media;
}

struct ColourQuestion {
    optics::DispersiveStack stack;
    std::vector<double> thickness_nm;
    optics::ObliqueLight light{};
    spectral::Illuminant illuminant;
    spectral::ObserverId observer{};
};

ColourQuestion read_question(const json& record, spectral::RangeRule rule)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    ColourQuestion question;
    question.stack.media = read_media(reader, rule, problems);
    const std::size_t layers = question.stack.media.empty() ? 0 : question.stack.media.size() - 2;
    const auto thickness = reader.numbers("d_nm", kNotNegative);
    if (!question.stack.media.empty() && thickness && thickness->size() != layers)
        reader.problem("d_nm", fmt::format("must have one thickness for each of the {} layers of n "
                                           "(got {})",
                                           layers, thickness->size()));
    question.stack.coherent = read_coherence(reader, layers);
    const auto angle = read_angle(reader);
    const auto polarisation = read_polarisation(reader);
    question.observer = read_observer(reader);
    const auto illuminant =
        reader.optional("illuminant") ? read_illuminant(reader) : spectral::named_illuminant("D65");
    reader.refuse_unknown_keys();
    problems.throw_if_any();
    question.thickness_nm = *thickness;
    question.light = {.cos_ambient = std::cos(*angle * std::numbers::pi / 180.0),
                      .share_of_s = polarisation == "s"   ? 1.0
                                    : polarisation == "p" ? 0.0
                                                          : 0.5};
    question.illuminant = *illuminant;
    return question;
}

optics::StackColour solve(const ColourQuestion& question, const spectral::ColourWeights& weights,
                          const std::string& sampling)
{
    if (const auto quadrature = named_quadrature(sampling, weights))
        return optics::SummedColours(question.stack, *quadrature)
            .at(question.thickness_nm, question.light);
    return optics::AdaptiveColours(question.stack, weights)
        .at(question.thickness_nm, question.light);
}

/// Of the media that the record names, each once.
std::vector<spectral::HeldEnds> held_media(const json& record, const ColourQuestion& question)
{
    std::set<std::string> known;
    std::vector<spectral::HeldEnds> held;
    for (const json& medium : record["n"]) {
        if (!medium.is_string() || !known.insert(medium.get<std::string>()).second) continue;
        if (auto ends = held_ends(spectral::library_medium(medium.get<std::string>()),
                                  question.illuminant, question.observer))
            held.push_back(std::move(*ends));
    }
    return held;
}

ordered_json evaluate_colour(const json& record, const ColourTarget& target,
                             const ColourChoices& choices)
{
    const ColourQuestion question = read_question(record, choices.range);
    // Errors count in a space like that of a screen; XYZ, without adaptation, is a matrix away.
    const spectral::ColourSpace& space = spectral::colour_space("lin_rec709_scene");
    const spectral::ColourWeights weights = reflectance_weights(
        question.illuminant, question.observer, space, spectral::Adaptation::none);
    const optics::StackColour colour = solve(question, weights, choices.sampling);
    const Vec3 white = spectral::white_under(question.illuminant, question.observer);
    const auto to_d65 =
        spectral::adaptation(choices.adaptation, white, spectral::d65_white(), kWithoutCat);
    const auto part = [&](const Vec3& rgb) {
        const Vec3 xyz = multiply(space.to_xyz_d65, rgb);
        return ordered_json{
            {"XYZ", xyz},
            {"Lab", spectral::xyz_to_lab(xyz, white)},
            {"rgb", rgb_of(multiply(to_d65, xyz), target, choices, spectral::ColourOf::surface)}};
    };
    ordered_json result = {{"reflectance", part(colour.reflectance)},
                           {"transmittance", part(colour.transmittance)},
                           {"space", target.name},
                           {"wavelengths", colour.evaluations}};
    if (const auto held = held_media(record, question); !held.empty())
        result["held_ends"] = held_json(held);
    return result;
}

}  // namespace

void add_eval_colour(CLI::App& eval, Session& session)
{
    const auto options = std::make_shared<ColourOptions>();
    CLI::App* colour =
        add_colour_command(eval, session, "colour", "colour of a multilayer at one angle",
                           kColourHelp, options, evaluate_colour);
    add_strict_range(*colour, options->strict_range);
}

}  // namespace nacre::tool
