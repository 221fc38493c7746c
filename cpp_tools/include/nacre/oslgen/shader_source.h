// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Hand-written shaders: what they declare, and their bodies for materials that fix some of it.

namespace nacre::oslgen {

/// `[[ string label = "…", float min = 0.0 ]]`: values by name; strings without their quotes.
using Metadata = std::map<std::string, std::string, std::less<>>;

struct ShaderParameter {
    std::string type;  ///< `float`, `closure color`, …
    std::string name;
    std::string size;   ///< of an array, as written; else empty
    std::string value;  ///< the default, as written, but for constants that C++ has too
    bool is_output = false;
    Metadata metadata;
    int line = 0;

    /// Value of an entry of the metadata, or `otherwise`.
    [[nodiscard]] std::string_view told(std::string_view name,
                                        std::string_view otherwise = "") const;
    /// Not for artists: `string widget = "null"`.
    [[nodiscard]] bool is_hidden() const { return told("widget") == "null"; }
};

struct ShaderSource {
    std::string file, text;
    std::string name;
    Metadata metadata;
    std::vector<ShaderParameter> parameters;
    std::string body;  ///< between its braces
    int line = 0;      ///< of its name

    [[nodiscard]] std::string_view told(std::string_view entry,
                                        std::string_view otherwise = "") const;
};

/// Whether the text is OSL, by a line that begins a shader; no template in TOML has one.
[[nodiscard]] bool is_shader_text(std::string_view text);

/// @param file  what to call the text in messages
/// @throws InputError with file and line where it is no shader
[[nodiscard]] ShaderSource parse_shader(std::string_view text, std::string_view file);

/// Shader of the source tree, by its name.
/// @throws InputError where there is none
[[nodiscard]] ShaderSource shipped_shader(std::string_view name);

/// What a material knows better than the shader's parameters say.
struct Given {
    /// Parameters and variables that are these texts: they are put in, and declared no more.
    std::map<std::string, std::string, std::less<>> constants;
    /// Variables that are computed so.
    std::map<std::string, std::string, std::less<>> variables;
};

/// The body's statements with that put in; `clamp` and `max` of numbers are done.
/// @pre the statements that declare what is given stand by themselves, not inside others
[[nodiscard]] std::string specialised(const ShaderSource& shader, const Given& given);

}  // namespace nacre::oslgen
