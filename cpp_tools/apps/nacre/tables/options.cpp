// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/options.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/spectral/illuminant.h"
#include "shared/held_ends.h"

namespace nacre::tool {

void add_table_options(CLI::App& command, TableOptions& options)
{
    command
        .add_option("--tolerance", options.tolerance,
                    "largest ΔE00 between texels; decides the size")
        ->capture_default_str();
    add_light_options(command, options);
}

void add_light_options(CLI::App& command, TableOptions& options)
{
    add_illuminant_options(command, options);
    add_colour_target_options(command, options.colour);
}

void add_illuminant_options(CLI::App& command, TableOptions& options)
{
    command
        .add_option("--illuminant", options.illuminant,
                    fmt::format("{}, {}", fmt::join(spectral::illuminant_names(), ", "),
                                spectral::kIlluminantForms))
        ->capture_default_str();
    command.add_option("--observer", options.observer, "cie1931, cie1964")->capture_default_str();
    add_adaptation_option(command, options.adaptation);
    add_strict_range(command, options.strict_range);
}

namespace {

/// Before anything is computed, and with a word on what to do.
void refuse_to_adapt(const spectral::Illuminant& illuminant, const TableProvenance& provenance)
{
    const spectral::Vec3 white = spectral::white_under(illuminant, provenance.observer);
    (void)spectral::adaptation(provenance.adaptation, white, spectral::d65_white(), kWithoutCat);
}

}  // namespace

ResolvedTableOptions resolve(const TableOptions& options)
{
    if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance))
        throw InputError(
            {"", 0, "--tolerance", fmt::format("must be > 0 (got {})", options.tolerance)});
    const ColourTarget target = resolve_colour_target(options.colour);
    ResolvedTableOptions result;
    result.provenance.space = linear_space(target);
    result.provenance.built_in_space = target.built_in;
    const spectral::Illuminant illuminant = spectral::named_illuminant(options.illuminant);
    result.provenance.illuminant = illuminant.name;
    result.provenance.observer = spectral::observer_from_name(options.observer);
    result.provenance.adaptation = spectral::adaptation_from_name(options.adaptation);
    refuse_to_adapt(illuminant, result.provenance);
    result.compile.illuminant = result.provenance.illuminant;
    result.compile.observer = result.provenance.observer;
    result.compile.adaptation = result.provenance.adaptation;
    result.compile.space = target.name;
    if (!target.built_in) result.compile.custom_space = result.provenance.space;
    result.compile.tolerance = options.tolerance;
    result.compile.range = range_rule(options.strict_range);
    return result;
}

}  // namespace nacre::tool
