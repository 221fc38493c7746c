// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "nacre/kinds/kind.h"
#include "nacre/material/schema.h"

namespace nacre::kinds {

/// What a kind adds to the JSON schema of templates.
struct KindSchema {
    material::SchemaJson properties;                                    ///< of the root
    std::vector<std::string_view> required;                             ///< of them
    material::SchemaJson definitions = material::SchemaJson::object();  ///< that they refer to
};

/// What is known of a kind before there is a material of it.
struct KindInfo {
    std::string_view name;
    /// The section by which a template says that it is of this kind; the kind without one is what
    /// templates are that have none of them.
    std::string_view section;
    std::vector<material::SliderInfo> sliders;
    std::vector<material::FieldInfo> surface;  ///< more fields of `[surface]`
    KindSchema (*schema)();
    std::shared_ptr<const Kind> (*read)(material::Section& root, material::TemplateHead& head);
};

/// Specialised by each kind, in its folder.
template <class K>
KindInfo kind_info();

}  // namespace nacre::kinds
