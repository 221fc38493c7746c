// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/entry_kind.h"

#include <gtest/gtest.h>

namespace nacre::spectral {
namespace {

TEST(EntryKind, HasAFolderAndAnExtension)
{
    EXPECT_EQ(entry_folder(EntryKind::medium), "optical_constants/");
    EXPECT_EQ(entry_extension(EntryKind::medium), ".yml");
    EXPECT_EQ(entry_folder(EntryKind::spectrum), "spectra/");
    EXPECT_EQ(entry_extension(EntryKind::spectrum), ".csv");
}

}  // namespace
}  // namespace nacre::spectral
