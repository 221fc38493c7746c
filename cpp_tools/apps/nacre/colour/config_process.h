// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "modules/config_space.h"
#include "shared/child_process.h"

namespace nacre::tool {

/// A Python whose PyOpenColorIO reads one config: integrations/ocio/read_config.py.
class ConfigProcess : public std::enable_shared_from_this<ConfigProcess> {
public:
    /// Nothing where the program cannot be started, or is no Python.
    [[nodiscard]] static std::shared_ptr<ConfigProcess> start(const std::string& python);

    /// Of its OpenColorIO; empty where it has none.
    [[nodiscard]] const std::string& version() const noexcept { return version_; }

    /// The conversion keeps the process; threads may share it.
    /// @throws std::runtime_error with what is wrong with the config, in one line
    [[nodiscard]] ConfigSpace read(const std::string& config, const std::string& space);

private:
    explicit ConfigProcess(const std::string& python);
    [[nodiscard]] spectral::Vec3 convert(const spectral::Vec3& xyz_d65);

    Dialogue dialogue_;
    std::mutex turn_;
    std::string version_;
};

}  // namespace nacre::tool
