// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace nacre::spectral {

/// Columns of numbers from an embedded CSV file: `#` comments, one line of column names, rows.
struct CsvTable {
    std::vector<std::vector<double>> columns;
};

/// @param path  as in find_resource(): the file is part of the library
/// @throws std::logic_error when it is missing or malformed, which is a fault of the build.
[[nodiscard]] CsvTable load_csv(std::string_view path, std::size_t columns);

}  // namespace nacre::spectral
