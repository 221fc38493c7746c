// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "base/kept_text.h"

#include <mutex>
#include <set>

namespace nacre::capi {

const char* kept(const std::string& text)
{
    static std::mutex mutex;
    static std::set<std::string> all;
    const std::lock_guard lock(mutex);
    return all.insert(text).first->c_str();
}

}  // namespace nacre::capi
