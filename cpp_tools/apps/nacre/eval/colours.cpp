// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "eval/colours.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/spectral/colour_quadrature.h"
#include "shared/held_ends.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

/// --range, over the rgb of all records that have one.
void map_range(std::vector<ordered_json>& records, const std::string& range)
{
    if (range == "none") return;
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

ColourChoices resolve_choices(const ColourOptions& options, const ColourTarget& target)
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

}  // namespace

spectral::Vec3 rgb_of(const spectral::Vec3& xyz_d65, const ColourTarget& target,
                      const ColourChoices& choices, spectral::ColourOf what)
{
    // Only a linear space has a luminance; resolve_choices() saw to it that it is not needed
    // elsewhere.
    const spectral::Vec3 luminance =
        target.linear ? target.linear->to_xyz_d65[1] : spectral::Vec3{};
    return spectral::map_to_gamut(target.from_xyz_d65(xyz_d65), choices.gamut, luminance, what);
}

CLI::App* add_colour_command(CLI::App& eval, Session& session, const char* name,
                             const char* description, const char* help,
                             const std::shared_ptr<ColourOptions>& options,
                             ColourEvaluator evaluate)
{
    CLI::App& kind = *add_record_command(eval, name, description, help, options);
    add_colour_target_options(kind, options->target);
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
            const ColourTarget target = resolve_colour_target(options->target);
            const ColourChoices choices = resolve_choices(*options, target);
            return evaluate_file(
                session, *options,
                [&](const json& record) { return evaluate(record, target, choices); },
                [&](std::vector<ordered_json>& records) { map_range(records, options->range); });
        };
    });
    return &kind;
}

}  // namespace nacre::tool
