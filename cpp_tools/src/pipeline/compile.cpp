// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/pipeline/compile.h"
#include "nacre/kinds/held_media.h"

#include <utility>

#include "nacre/core/diagnostics.h"
#include "nacre/oslgen/write.h"

namespace nacre::pipeline {
namespace {

oslgen::ColourSystem colour_system(const CompileOptions& options)
{
    const spectral::ColourWeights weights = options.weights();
    return {.space = weights.space,
            .illuminant = weights.illuminant,
            .observer = std::string(spectral::observer_name(weights.observer)),
            .adaptation = std::string(spectral::adaptation_name(options.adaptation)),
            .to_xyz_d65 = weights.to_xyz_d65};
}

}  // namespace

CompiledMaterial compile(const MaterialTemplate& source, const CompileOptions& options)
{
    const bool is_adapted = options.adaptation != spectral::Adaptation::none;
    if (!is_adapted && source.kind->traits().wavelength_per_path)
        throw InputError(Diagnostic{source.file, 0, "",
                                    "must be a film where colours are not adapted (--cat none): "
                                    "glasses and gratings split white light"});
    auto [program, tables] = source.kind->prepare(source, options);
    program.head = static_cast<const material::TemplateHead&>(source);
    program.kind = source.kind->name();
    program.traits = source.kind->traits();
    program.colours = colour_system(options);
    oslgen::apply_parameters(source, program.sockets);
    for (const spectral::HeldEnds& held : held_media(source, options))
        program.held.push_back({held.medium, held.range_nm, held.percent, held.note()});
    oslgen::ProgramText text = oslgen::write(program);
    return {.id = source.id,
            .osl = std::move(text.osl),
            .manifest = std::move(text.manifest),
            .tables = std::move(tables)};
}

}  // namespace nacre::pipeline
