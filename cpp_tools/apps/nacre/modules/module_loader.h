// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Parts of the tool that are loaded where a command first needs them. OpenImageIO brings 250
/// libraries, which take longer to load than most commands to run.

namespace nacre::tool {

/// The interface of `<prefix>/lib/nacre/nacre_NAME.so`.
/// @param library  what the module links to, and how to get it
/// @throws InputError where it cannot be loaded
[[nodiscard]] const void* load_module(const char* name, const char* library);

/// Stays loaded once it is.
template <class Interface>
[[nodiscard]] const Interface& loaded_module()
{
    static const auto* const interface =
        static_cast<const Interface*>(load_module(Interface::kModule, Interface::kLibrary));
    return *interface;
}

}  // namespace nacre::tool
