// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/text_lines.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::spectral {

/// Collects the samples of one spectrum from words of a file, and what is wrong with them.
class SampleList {
public:
    explicit SampleList(FileProblems& problems) : problems_(problems) {}

    /// @return false when there are too many: no more need come
    bool add(int line, std::string_view wavelength_nm, std::string_view value);
    /// Nothing when there are fewer than two, which is a problem of the whole file, or any other
    /// problem is known.
    [[nodiscard]] std::optional<Spectrum> finish();

private:
    std::optional<double> number(int line, const char* field, std::string_view word);

    FileProblems& problems_;
    std::vector<double> wavelengths_nm_, values_;
};

}  // namespace nacre::spectral
