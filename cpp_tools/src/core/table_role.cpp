// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/table_role.h"

#include <array>
#include <cstddef>

namespace nacre {
namespace {

constexpr std::array<std::string_view, 6> kOf{"R", "T", "R_inner", "T_inner", "lobe_R", "lobe_T"};
constexpr std::array<std::string_view, 4> kContents{"smooth", "rough", "further", "powers"};
constexpr std::array<std::string_view, 4> kEndings{"", "_rough", "_further", "_schlick"};

using Names = std::array<std::array<std::array<std::string, 2>, kContents.size()>, kOf.size()>;

Names all_names()
{
    Names names;
    for (std::size_t of = 0; of < kOf.size(); ++of)
        for (std::size_t content = 0; content < kContents.size(); ++content) {
            auto& [whole, bare] = names[of][content];
            whole = std::string(kOf[of]).append(kEndings[content]);
            bare = whole + "_bare";
        }
    return names;
}

}  // namespace

std::string_view table_of_name(TableOf of)
{
    return kOf[static_cast<std::size_t>(of)];
}

std::string_view table_content_name(TableContent content)
{
    return kContents[static_cast<std::size_t>(content)];
}

const std::string& table_name(const TableRole& role)
{
    static const Names names = all_names();
    return names[static_cast<std::size_t>(role.of)][static_cast<std::size_t>(role.content)]
                [role.is_bare ? 1 : 0];
}

std::optional<TableRole> table_role(std::string_view name)
{
    for (std::size_t of = 0; of < kOf.size(); ++of)
        for (std::size_t content = 0; content < kContents.size(); ++content)
            for (const bool bare : {false, true}) {
                const TableRole role{static_cast<TableOf>(of), static_cast<TableContent>(content),
                                     bare};
                if (table_name(role) == name) return role;
            }
    return std::nullopt;
}

}  // namespace nacre
