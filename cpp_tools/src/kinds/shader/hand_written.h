// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "nacre/kinds/kind.h"
#include "nacre/oslgen/shader_source.h"

namespace nacre::kinds {

/// A shader of somebody's own, with what it says of itself in its metadata. Its template is not
/// TOML but its OSL, so it stands in no list of sections.
class HandWritten final : public Kind {
public:
    static constexpr std::string_view kName = "shader";

    oslgen::ShaderSource shader;
    std::vector<oslgen::Socket> sockets;
    oslgen::Traits told;
    std::optional<nlohmann::json> nodes, bands;  ///< see shader/node_form.h
    nlohmann::json presets = nlohmann::json::array();

    [[nodiscard]] std::string_view name() const override { return kName; }
    [[nodiscard]] oslgen::Traits traits() const override { return told; }
    [[nodiscard]] std::vector<const material::MediumSpec*> media() const override { return {}; }
    [[nodiscard]] std::string driven_socket() const override;
    [[nodiscard]] Prepared prepare(const MaterialTemplate& source,
                                   const CompileOptions& options) const override;
    void check(const MaterialTemplate& source, const CompileOptions& options) const override
    {
        static_cast<void>(prepare(source, options));
    }
    [[nodiscard]] std::variant<MaterialTemplate, std::string> exported(
        const MaterialTemplate& source) const override;
};

/// The shader's name without ours before it.
[[nodiscard]] std::string material_id(const oslgen::ShaderSource& shader);

/// @throws InputError with every problem of the file, each with its line.
[[nodiscard]] MaterialTemplate read_shader(std::string_view osl, std::string_view file);

}  // namespace nacre::kinds
