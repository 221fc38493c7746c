// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/kind_info.h"

namespace nacre::kinds {

/// `[glass]`: smooth dispersive glass by a formula or a library entry.
class Glass final : public Kind {
public:
    static constexpr std::string_view kName = "glass";

    material::MediumSpec medium;

    [[nodiscard]] std::string_view name() const override { return kName; }
    [[nodiscard]] oslgen::Traits traits() const override
    {
        return {.truth = oslgen::Truth::white, .is_body = true, .wavelength_per_path = true};
    }
    [[nodiscard]] std::vector<const material::MediumSpec*> media() const override
    {
        return {&medium};
    }
    [[nodiscard]] std::string driven_socket() const override { return ""; }
    [[nodiscard]] Prepared prepare(const MaterialTemplate& source,
                                   const CompileOptions& options) const override;
    void check(const MaterialTemplate& source, const CompileOptions& options) const override
    {
        static_cast<void>(prepare(source, options));
    }
    /// Its surface: two media and nothing in between.
    [[nodiscard]] std::variant<MaterialTemplate, std::string> exported(
        const MaterialTemplate& source) const override;
};

template <>
KindInfo kind_info<Glass>();

}  // namespace nacre::kinds
