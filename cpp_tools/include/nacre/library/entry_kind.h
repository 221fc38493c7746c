// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// @file
/// What a library has entries of, and where it keeps them.

namespace nacre::spectral {

enum class EntryKind {
    medium,    ///< optical_constants/<key>.yml
    spectrum,  ///< spectra/<key>.csv
};

/// `optical_constants/` or `spectra/`, and `.yml` or `.csv`.
[[nodiscard]] std::string_view entry_folder(EntryKind kind) noexcept;
[[nodiscard]] std::string_view entry_extension(EntryKind kind) noexcept;

}  // namespace nacre::spectral
