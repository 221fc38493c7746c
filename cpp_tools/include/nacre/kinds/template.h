// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "nacre/material/head.h"

/// @file
/// The template: the one source of a material, as the author wrote it.

namespace nacre::kinds {

class Kind;

struct MaterialTemplate : material::TemplateHead {
    std::shared_ptr<const Kind> kind;  ///< what the material is made of
};

}  // namespace nacre::kinds
