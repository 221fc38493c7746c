// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

/// @file
/// What a table of a material holds. Tables are named after it, and nothing is read from a name.

namespace nacre {

/// Of which light.
enum class TableOf {
    R,
    T,
    R_inner,  ///< of the film from below
    T_inner,
    lobe_R,  ///< what a renderer's lobes of clear glass bring along
    lobe_T,
};

enum class TableContent {
    smooth,   ///< at roughness 0
    rough,    ///< means over facets
    further,  ///< what leaves after two and more bounces
    powers,   ///< coefficients of powers of the cosine
};

struct TableRole {
    TableOf of = TableOf::R;
    TableContent content = TableContent::smooth;
    bool is_bare = false;  ///< of the substrate without its film

    bool operator==(const TableRole&) const = default;
};

[[nodiscard]] std::string_view table_of_name(TableOf of);
[[nodiscard]] std::string_view table_content_name(TableContent content);

/// `R`, `T_rough`, `R_further_bare`, …: the file is `<id>_<name>.exr`.
[[nodiscard]] const std::string& table_name(const TableRole& role);

/// The role that has this name, or nothing.
[[nodiscard]] std::optional<TableRole> table_role(std::string_view name);

}  // namespace nacre
