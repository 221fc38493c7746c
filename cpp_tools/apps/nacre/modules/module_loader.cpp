// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "modules/module_loader.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/core/version.h"
#include "shared/share_files.h"

namespace nacre::tool {
namespace {

using Entry = const void* (*)(const char* tool_version);  // see modules/module_entry.h

}  // namespace

const void* load_module(const char* name, const char* library)
{
    const auto file = installed_path(fmt::format("lib/nacre/nacre_{}.so", name));
    void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
        throw InputError({file.string(), 0, "",
                          fmt::format("cannot be loaded ({}); it needs {}", dlerror(), library)});
    const auto entry = reinterpret_cast<Entry>(dlsym(handle, "nacre_module"));
    const void* interface = entry ? entry(std::string(version()).c_str()) : nullptr;
    if (!interface)
        throw InputError(
            {file.string(), 0, "",
             fmt::format("is not of this nacre, {}: install the tool anew as a whole", version())});
    return interface;
}

}  // namespace nacre::tool
