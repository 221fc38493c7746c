// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Files that are compiled into the library, so that it works without a data folder.

namespace nacre {

/// A file by its path below one of the embedded roots, e.g. `optical_constants/Fe/Johnson.yml`,
/// `cmf/cie_1931_2deg_1nm.csv`, `osl/nacre/nacre_fresnel.h`, `templates/soap_film.toml`.
[[nodiscard]] std::optional<std::string_view> find_resource(std::string_view path) noexcept;

/// Paths that start with `prefix`, in ascending order.
[[nodiscard]] std::vector<std::string_view> list_resources(std::string_view prefix);

}  // namespace nacre
