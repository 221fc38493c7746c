// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include <OpenColorIO/OpenColorIO.h>

#include "modules/config_reader.h"
#include "modules/module_entry.h"

namespace OCIO = OCIO_NAMESPACE;

// Its twin for other versions is cpp_tools/integrations/ocio/read_config.py: what one does the
// other does.
namespace nacre::tool {
namespace {

using spectral::Vec3;

std::string first_line(const char* text)
{
    const std::string_view view = text;
    return std::string(view.substr(0, view.find('\n')));
}

std::string version()
{
    return OCIO::GetVersion();
}

OCIO::ConstConfigRcPtr load(const std::string& file)
{
    OCIO::SetLoggingLevel(OCIO::LOGGING_LEVEL_NONE);
    try {
        OCIO::ConstConfigRcPtr config = OCIO::Config::CreateFromFile(file.c_str());
        config->validate();
        return config;
    } catch (const OCIO::Exception& error) {
        throw std::runtime_error(first_line(error.what()));
    }
}

void add_conversion(ConfigSpace& result, const OCIO::Config& config, const std::string& space)
{
    try {
        const OCIO::ConstCPUProcessorRcPtr processor =
            config.getProcessor(kInterchangeRole, space.c_str())
                ->getOptimizedCPUProcessor(OCIO::OPTIMIZATION_LOSSLESS);
        result.from_xyz_d65 = [processor](const Vec3& xyz) {
            float pixel[3] = {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]),
                              static_cast<float>(xyz[2])};
            processor->applyRGB(pixel);
            return Vec3{pixel[0], pixel[1], pixel[2]};
        };
    } catch (const OCIO::Exception& error) {
        result.failure = first_line(error.what());
    }
}

ConfigSpace read(const std::string& file, const std::string& space)
{
    const OCIO::ConstConfigRcPtr config = load(file);
    ConfigSpace result;
    const int spaces = config->getNumColorSpaces(), roles = config->getNumRoles();
    result.names.reserve(static_cast<std::size_t>(spaces) + static_cast<std::size_t>(roles));
    for (int i = 0; i < spaces; ++i) result.names.emplace_back(config->getColorSpaceNameByIndex(i));
    for (int i = 0; i < roles; ++i) result.names.emplace_back(config->getRoleName(i));
    const OCIO::ConstColorSpaceRcPtr found = config->getColorSpace(space.c_str());
    result.is_known = found != nullptr;
    result.is_data = found && found->isData();
    result.has_interchange = config->hasRole(kInterchangeRole);
    if (result.is_known && !result.is_data && result.has_interchange)
        add_conversion(result, *config, space);
    return result;
}

constexpr ConfigReader kReader = {version, read};

}  // namespace
}  // namespace nacre::tool

NACRE_MODULE_ENTRY(nacre::tool::kReader)
