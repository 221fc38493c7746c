// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "materials/shader_compiler.h"

#include <cstdlib>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "shared/child_process.h"

namespace nacre::tool {
namespace {

/// Cycles' compiler; it needs bpy to be loaded first.
constexpr const char* kCyclesCompiler =
    "import sys, bpy, _cycles; sys.exit(not _cycles.osl_compile(sys.argv[1], sys.argv[2]))";

}  // namespace

std::optional<ShaderCompiler> ShaderCompiler::find()
{
    ShaderCompiler compiler;
    if (const auto oslc = find_program("oslc")) {
        compiler.command_ = {oslc->string(), "-o"};
        compiler.description_ = oslc->string();
        return compiler;
    }
    const char* python = std::getenv("NACRE_PYTHON");
    if (!python || !*python) return std::nullopt;
    compiler.command_ = {python, "-c", kCyclesCompiler};
    compiler.description_ = fmt::format("bpy of {}", python);
    return compiler;
}

void ShaderCompiler::compile(const std::filesystem::path& folder, const std::string& name) const
{
    // In the folder and by bare names: an .oso quotes its source's path.
    std::vector<std::string> command = command_;
    const std::string source = name + ".osl", result = name + ".oso";
    const bool is_oslc = command.back() == "-o";
    command.insert(command.end(), {is_oslc ? result : source, is_oslc ? source : result});
    const ChildResult child =
        run_child(command, {.folder = folder, .environment = {}, .capture = true});
    if (child.exit_code != 0 || !std::filesystem::is_regular_file(folder / result))
        throw InputError(
            {source, 0, "", fmt::format("{} refused it: {}", description_, child.output)});
}

}  // namespace nacre::tool
