// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// @file
/// Rows of measured optical constants, and what is put right in them.

namespace nacre::spectral {

/// One row of a table, as a file has it.
struct IndexRow {
    int line = 0;
    double wavelength = 0.0;
    double n = 1.0;  ///< 1 in a table of k
    double k = 0.0;  ///< 0 in a table of n
};

/// k of a clear medium is measured to some thousandths, and fits leave rounding: what is not lower
/// is no gain.
inline constexpr double kLeastNoiseOfK = -0.005;

/// Puts right what published tables have wrong: rows out of order are sorted, of rows of one
/// wavelength the first counts, k < 0 is 0 down to kLeastNoiseOfK and its row left out below.
/// @return what was changed, each with the line of the first row; nothing for rows that are right
[[nodiscard]] std::vector<std::string> mend_rows(std::vector<IndexRow>& rows);

}  // namespace nacre::spectral
