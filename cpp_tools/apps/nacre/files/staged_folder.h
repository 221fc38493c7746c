// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

/// @file
/// A folder that appears whole.

namespace nacre::tool {

/// Made beside its target under a hidden name; takes the target's place at `commit()`, without it
/// the destructor removes it.
class StagedFolder {
public:
    /// @throws InputError when the folder cannot be made
    explicit StagedFolder(std::filesystem::path target);
    StagedFolder(StagedFolder&& other) noexcept;
    StagedFolder(const StagedFolder&) = delete;
    StagedFolder& operator=(const StagedFolder&) = delete;
    StagedFolder& operator=(StagedFolder&&) = delete;
    ~StagedFolder();

    [[nodiscard]] const std::filesystem::path& path() const noexcept { return temporary_; }

    /// Exchanges the two folders in one step where the file system can, and removes the old one.
    void commit();

private:
    std::filesystem::path target_, temporary_;
};

}  // namespace nacre::tool
