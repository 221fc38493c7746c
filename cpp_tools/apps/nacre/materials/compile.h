// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tables/options.h"

namespace nacre::tool {

using nlohmann::ordered_json;

struct Session;

/// One material that was compiled.
struct CompiledFolder {
    std::string id;
    std::filesystem::path folder;
    std::vector<spectral::HeldEnds> held;
    ordered_json summary;
};

struct CompileRequest {
    std::vector<std::string> inputs;  ///< template files
    std::filesystem::path output;     ///< folder of the materials' folders
    TableOptions table;
    bool shader_bytecode = true;  ///< write .oso where a compiler is at hand
};

/// Compiles all templates, then writes all of their folders.
/// @throws InputError with the problems of every template; nothing is written then
std::vector<CompiledFolder> compile_templates(const Session& session,
                                              const CompileRequest& request);

}  // namespace nacre::tool
