// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "nacre/material/fields.h"

/// @file
/// Parts of the JSON Schema (draft 2020-12) of templates.

namespace nacre::material {

using SchemaJson = nlohmann::ordered_json;

/// An object of these properties and no others.
[[nodiscard]] SchemaJson object_schema(SchemaJson properties, SchemaJson required);

/// The same with an entry for each field.
[[nodiscard]] SchemaJson fields_schema(std::span<const FieldInfo> fields);

/// `{"$ref": "#/$defs/NAME"}`
[[nodiscard]] SchemaJson reference_schema(const std::string& name);

/// A table that holds a medium, with more fields beside it.
[[nodiscard]] SchemaJson medium_schema(std::span<const FieldInfo> more = {});

}  // namespace nacre::material
