// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// @file
/// The one symbol of a module, for module_loader.h.

/// `interface` for a tool of the same version, else nothing: a struct of another would be misread.
#define NACRE_MODULE_ENTRY(interface)                                                            \
    extern "C" __attribute__((visibility("default"))) const void* nacre_module(const char* tool) \
    {                                                                                            \
        return std::string_view(tool) == NACRE_VERSION ? &(interface) : nullptr;                 \
    }
