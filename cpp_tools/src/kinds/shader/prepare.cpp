// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "nacre/kinds/shader_tables.h"
#include "shader/hand_written.h"
#include "shader/node_form.h"

namespace nacre::kinds {
namespace {

constexpr std::string_view kColourTables = "#include \"nacre/nacre_colour_tables.h\"\n";

/// With its colours in the space, under the light and for the observer of the options.
std::string text_for(const oslgen::ShaderSource& shader, const CompileOptions& options)
{
    std::string text = without_node_forms(shader.text);
    std::erase(text, '\r');  // of files from Windows
    const std::size_t at = text.find(kColourTables);
    if (at != std::string::npos)
        text.replace(at, kColourTables.size(), colour_tables_header(options.weights()));
    return text;
}

}  // namespace

std::string HandWritten::driven_socket() const
{
    constexpr std::string_view kThickness = "thickness_nm";
    const bool has_thickness =
        std::ranges::find(sockets, kThickness, &oslgen::Socket::name) != sockets.end();
    return has_thickness ? std::string(kThickness) : "";
}

Prepared HandWritten::prepare(const MaterialTemplate&, const CompileOptions& options) const
{
    Prepared result;
    result.program.sockets = sockets;
    result.program.body =
        oslgen::ShaderText{.text = text_for(shader, options), .nodes = nodes, .bands = bands};
    if (!presets.empty()) result.program.more["presets"] = presets;
    return result;
}

std::variant<MaterialTemplate, std::string> HandWritten::exported(const MaterialTemplate&) const
{
    return "it is a shader, of which only what it computes is known";
}

}  // namespace nacre::kinds
