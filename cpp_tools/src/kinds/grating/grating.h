// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/kind_info.h"
#include "nacre/material/fields.h"
#include "nacre/optics/grating.h"

namespace nacre::kinds {

/// `[grating]`: concentric tracks around the object's z axis.
class Grating final : public Kind {
public:
    static constexpr std::string_view kName = "grating";

    material::Quantity pitch_nm;
    optics::ProfileKind profile = optics::ProfileKind::rectangular;
    double depth_nm = 0.0;           ///< of a groove
    double duty = 0.5;               ///< fraction of the period that is raised; rectangular only
    material::MediumSpec cover;      ///< what fills the grooves; only its index enters their depth
    material::MediumSpec substrate;  ///< the reflecting metal
    int orders = 3;                  ///< ±1 … ±orders

    [[nodiscard]] std::string_view name() const override { return kName; }
    [[nodiscard]] oslgen::Traits traits() const override { return {.wavelength_per_path = true}; }
    [[nodiscard]] std::vector<const material::MediumSpec*> media() const override
    {
        return {&cover, &substrate};
    }
    [[nodiscard]] std::string driven_socket() const override { return ""; }
    [[nodiscard]] Prepared prepare(const MaterialTemplate& source,
                                   const CompileOptions& options) const override;
    void check(const MaterialTemplate& source, const CompileOptions& options) const override
    {
        static_cast<void>(prepare(source, options));
    }
    [[nodiscard]] std::variant<MaterialTemplate, std::string> exported(
        const MaterialTemplate&) const override
    {
        return "its colours depend on the direction of the light, not only on the angle of view";
    }
};

template <>
KindInfo kind_info<Grating>();

}  // namespace nacre::kinds
