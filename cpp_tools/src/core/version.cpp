// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/version.h"

namespace nacre {

std::string_view version() noexcept
{
    return NACRE_VERSION;
}

}  // namespace nacre
