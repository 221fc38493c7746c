// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace nacre::tool {

/// Something that turns an .osl into an .oso.
class ShaderCompiler {
public:
    /// `oslc` on the path, else the Python with Blender's `bpy` that NACRE_PYTHON names; nothing
    /// where neither is there.
    [[nodiscard]] static std::optional<ShaderCompiler> find();

    /// Compiles `folder/name.osl` to `folder/name.oso`.
    /// @throws InputError with the compiler's own message
    void compile(const std::filesystem::path& folder, const std::string& name) const;

    [[nodiscard]] const std::string& description() const noexcept { return description_; }

private:
    std::vector<std::string> command_;  ///< takes the names of source and result
    std::string description_;
};

}  // namespace nacre::tool
