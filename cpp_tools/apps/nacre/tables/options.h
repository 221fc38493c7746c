// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "colour/target.h"
#include "nacre/pipeline/compile.h"
#include "tables/image.h"

/// @file
/// Options that `bake stack` and `compile` share: how a table becomes colour, and how exact.

namespace nacre::tool {

struct TableOptions {
    double tolerance = 0.1;
    std::string illuminant = "D65", observer = "cie1931", adaptation = "bradford";
    bool strict_range = false;
    ColourTargetOptions colour;
};

struct ResolvedTableOptions {
    kinds::CompileOptions compile;
    TableProvenance provenance;  ///< the stack is the caller's to add
};

/// All of them.
void add_table_options(CLI::App& command, TableOptions& options);
/// Those without the tolerance, for colours that are exact.
void add_light_options(CLI::App& command, TableOptions& options);
/// Illuminant, observer, adaptation and the range of media alone, where a format fixes the space.
void add_illuminant_options(CLI::App& command, TableOptions& options);

/// @throws InputError for names that do not exist, or a space that is not scene-linear
[[nodiscard]] ResolvedTableOptions resolve(const TableOptions& options);

}  // namespace nacre::tool
