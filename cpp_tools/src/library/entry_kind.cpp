// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/entry_kind.h"

namespace nacre::spectral {

std::string_view entry_folder(EntryKind kind) noexcept
{
    return kind == EntryKind::medium ? "optical_constants/" : "spectra/";
}

std::string_view entry_extension(EntryKind kind) noexcept
{
    return kind == EntryKind::medium ? ".yml" : ".csv";
}

}  // namespace nacre::spectral
