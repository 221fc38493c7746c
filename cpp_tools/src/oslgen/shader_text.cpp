// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "nacre/oslgen/literals.h"
#include "writers.h"

namespace nacre::oslgen {
namespace {

/// Two question marks may begin a trigraph, which the preprocessor warns of even in strings, and
/// Cycles takes warnings for errors; neighbouring literals are one string.
std::string string_literal(std::string_view text)
{
    std::string result = "\"";
    char before = 0;
    for (const char c : text) {
        if (c == '?' && before == '?') result += "\" \"";
        if (c == '"' || c == '\\') result += '\\';
        result += c;
        before = c;
    }
    return result + '"';
}

/// In a comment nothing joins what was taken apart.
std::string comment_text(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '?' && result.ends_with('?')) result += ' ';
        result += c;
    }
    return result;
}

std::string parameter(const Socket& socket)
{
    if (socket.type == "normal")
        return "    normal surface_normal = N" + metadata(socket.label, socket.description);
    if (socket.type == "tangent")
        return "    vector tangent = vector(0.0)" + metadata(socket.label, socket.description);
    if (socket.type == "color")
        return fmt::format("    color {} = {}", socket.name, literal(socket.colour)) +
               metadata(socket.label, socket.description);
    if (socket.type == "int")
        return fmt::format("    int {} = {}", socket.name, static_cast<int>(socket.value)) +
               metadata(socket.label, socket.description,
                        fmt::format(", int min = {}, int max = {}", static_cast<int>(socket.min),
                                    static_cast<int>(socket.max)));
    const std::string units =
        socket.unit == "1" ? "" : fmt::format(", string units = {}", string_literal(socket.unit));
    return fmt::format("    float {} = {}", socket.name, literal(socket.value)) +
           metadata(socket.label, socket.description,
                    fmt::format("{}, float min = {}, float max = {}", units, literal(socket.min),
                                literal(socket.max)));
}

std::string constant(const Constant& constant)
{
    return fmt::format(",\n    {} = {}", constant.declaration, constant.value) +
           metadata(constant.label, constant.help, kHidden);
}

/// What a shader has of its own: what it includes, parameters after the artist's, statements.
struct Parts {
    std::string includes, parameters, statements;
};

Parts parts(const TableSurface& surface)
{
    return {surface_includes(surface), surface_parameters(surface), surface_statements(surface)};
}

Parts parts(const ShaderBody& body)
{
    std::string includes;
    for (const std::string& header : body.includes)
        includes += fmt::format("#include \"{}\"\n", header);
    return {std::move(includes), "", body.statements};
}

std::string shader_of(const Program& program, const Parts& own)
{
    const material::TemplateHead& head = program.head;
    std::string parameters;
    for (const Socket& socket : program.sockets)
        parameters += (parameters.empty() ? "" : ",\n") + parameter(socket);
    for (const Constant& each : program.constants) parameters += constant(each);
    parameters += own.parameters;
    return fmt::format(
        "{}\n"
        "// {}. Made by `nacre compile`; colours are in {}.\n"
        "shader nacre_{}"
        "\n[[ string label = {}, string help = {} ]]\n"
        "(\n{},\n    output closure color BSDF = 0\n)\n{{\n{}}}\n",
        own.includes, comment_text(head.name), program.colours.space, head.id,
        string_literal(head.name), string_literal(head.description), parameters, own.statements);
}

struct Text {
    const Program& program;

    std::string operator()(const ShaderText& shader) const { return shader.text; }
    std::string operator()(const auto& body) const { return shader_of(program, parts(body)); }
};

}  // namespace

std::string metadata(std::string_view label, std::string_view help, std::string_view more)
{
    return fmt::format("\n        [[ string label = {}, string help = {}{} ]]",
                       string_literal(label), string_literal(help), more);
}

std::string shader_text(const Program& program)
{
    return std::visit(Text{program}, program.body);
}

}  // namespace nacre::oslgen
