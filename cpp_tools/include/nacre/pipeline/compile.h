// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/lut/film_table.h"
#include "nacre/material/template.h"
#include "nacre/media/working_range.h"
#include "nacre/spectral/colour.h"

/// @file
/// Template in, compiled material out: looks up media, bakes tables, generates shader and manifest.
/// Shared by the command-line tool, the C API and so the Blender extension. Writes no files.

namespace nacre::pipeline {

struct CompileOptions {
    std::string illuminant = "D65";
    spectral::ObserverId observer = spectral::ObserverId::cie1931;
    /// None: films alone, whose tables then have the colour of the light in them.
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    std::string space = "lin_rec709_scene";
    /// Instead of `space`: a scene-linear space that the library does not know by name.
    std::optional<spectral::ColourSpace> custom_space;
    spectral::RangeRule range = spectral::RangeRule::hold_ends;  ///< of the media's data
    double tolerance = 0.1;                                      ///< ΔE00
    std::function<bool(double)> progress;
};

struct CompiledMaterial {
    std::string id;
    std::string osl;       ///< text of `<id>.osl`
    std::string manifest;  ///< text of `<id>.json`
    std::vector<lut::Table> tables;
};

/// @throws InputError with the template's file and lines.
[[nodiscard]] CompiledMaterial compile(const material::MaterialTemplate& source,
                                       const CompileOptions& options);

/// The stack of a film template with media looked up; what `bake stack` and tests use.
/// Every wavelength-dependent index is on the 1 nm grid.
[[nodiscard]] lut::FilmTableRequest film_request(const material::MaterialTemplate& source,
                                                 const CompileOptions& options);

/// Media of a template whose data end within 360 … 830 nm, each once; the manifest has them, too.
/// @throws InputError with the template's lines, also where a medium may not be held
[[nodiscard]] std::vector<spectral::HeldEnds> held_media(const material::MaterialTemplate& source,
                                                         const CompileOptions& options);

}  // namespace nacre::pipeline
