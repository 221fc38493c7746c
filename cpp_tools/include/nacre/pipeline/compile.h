// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/kinds/kind.h"
#include "nacre/lut/table.h"

/// @file
/// Template in, compiled material out: looks up media, bakes tables, generates shader and manifest.
/// Shared by the command-line tool, the C API and so the Blender extension. Writes no files.

namespace nacre::pipeline {

using kinds::CompileOptions, kinds::MaterialTemplate;

struct CompiledMaterial {
    std::string id;
    std::string osl;       ///< text of `<id>.osl`
    std::string manifest;  ///< text of `<id>.json`
    std::vector<lut::Table> tables;
};

/// @throws InputError with the template's file and lines.
[[nodiscard]] CompiledMaterial compile(const MaterialTemplate& source,
                                       const CompileOptions& options);

}  // namespace nacre::pipeline
