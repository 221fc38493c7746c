// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nacre/media/optical_constants.h"
#include "nacre/spectral/named_spectrum.h"

/// @file
/// Finding entries of the library by their words.

namespace nacre::spectral {

/// Both are wanted; an empty one asks for nothing.
struct LibrarySearch {
    std::string text;  ///< part of a key, a name, a formula, a tag or a citation, whatever its case
    std::string tag;   ///< a whole one, e.g. `metal`
};

[[nodiscard]] bool matches(const Medium& medium, const LibrarySearch& search);
[[nodiscard]] bool matches(const NamedSpectrum& spectrum, const LibrarySearch& search);

/// Keys of what matches, ascending. A file of the user's own that cannot be read is found by its
/// key alone, and by no tag.
[[nodiscard]] std::vector<std::string> find_media(const LibrarySearch& search);
[[nodiscard]] std::vector<std::string> find_spectra(const LibrarySearch& search);

}  // namespace nacre::spectral
