// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/text_lines.h"

/// @file
/// Rows of numbers under names, as CSV files, spreadsheets and instruments have them: between
/// tabs, semicolons, commas or spaces, with decimal commas where those do not separate.

namespace nacre::spectral {

/// The first column is the wavelength in nm, above 0 and ascending, though a file may have it
/// descending or in µm; all numbers are finite.
struct NumberTable {
    int line = 0;                    ///< of the names, or of the first row
    std::vector<std::string> names;  ///< of the columns after the first; empty where none are given
    std::vector<bool> per_cent;      ///< of the columns, by their names
    std::vector<int> lines;          ///< of the rows
    std::vector<double> wavelengths_nm;
    std::vector<std::vector<double>> columns;
};

struct NumberTables {
    std::vector<NumberTable> tables;              ///< a row of names starts another one
    std::map<std::string, std::string> comments;  ///< `# KEY: value`; keys in upper case
};

/// @throws InputError with all that is wrong.
[[nodiscard]] NumberTables read_number_tables(std::string_view text, std::string_view file);

}  // namespace nacre::spectral
