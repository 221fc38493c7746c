// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "base/guard.h"

#include "nacre/core/version.h"

namespace nacre::capi {
namespace {

std::string& last_error() noexcept
{
    thread_local std::string message;
    return message;
}

}  // namespace

void set_last_error(const char* message) noexcept
{
    try {
        last_error() = message;
    } catch (...) {
        last_error().clear();
    }
}

}  // namespace nacre::capi

extern "C" {

int nacre_api_version(void)
{
    return NACRE_API_VERSION;
}

const char* nacre_version(void)
{
    return nacre::version().data();
}

const char* nacre_last_error(void)
{
    return nacre::capi::last_error().c_str();
}
}
