// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "files/image_file.h"
#include "nacre/lut/film_table.h"
#include "tables/options.h"

/// @file
/// One table of a film as a file holds it.

namespace nacre::tool {

struct Session;

/// `reflectance` or `transmittance`
struct StackTableOptions {
    std::string quantity = "reflectance", size, depth;
};

/// --quantity, --size and --depth.
void add_stack_table_options(CLI::App& command, StackTableOptions& options);

/// Of floats, for what a renderer interpolates. @throws InputError for a PNG
[[nodiscard]] Encoding table_encoding(const std::string& output, const std::string& depth);

/// Sized by the request's tolerance or by --size; its error is that of the depth. Shows progress.
[[nodiscard]] lut::Table bake_stack_table(const Session& session, lut::FilmTableRequest request,
                                          const StackTableOptions& options, Depth depth,
                                          const spectral::ColourSpace& space);

}  // namespace nacre::tool
