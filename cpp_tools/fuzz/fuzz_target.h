// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "nacre/core/diagnostics.h"
#include "nacre/core/limits.h"

/// @file
/// What every target demands of a reader: it takes any bytes, and refuses by an InputError that
/// says why. Any other exception ends the run, as a finding of a sanitizer does.

namespace nacre::fuzz {

/// Ends the run: what a reader did is wrong although no sanitizer saw it.
inline void require(bool good, const char* what)
{
    if (good) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

/// @param read  called with the bytes as text
template <class Read>
int run(const std::uint8_t* data, std::size_t size, Read&& read)
{
    // libFuzzer's bytes are bytes of a file. NOLINTNEXTLINE(*-reinterpret-cast)
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        read(text);
    } catch (const InputError& error) {
        require(!error.diagnostics().empty(), "an InputError without a problem");
        require(error.diagnostics().size() <= static_cast<std::size_t>(kMaxProblems),
                "more problems than a reader is to tell");
        for (const Diagnostic& problem : error.diagnostics())
            require(!problem.message.empty(), "a problem without a message");
    }
    return 0;
}

}  // namespace nacre::fuzz
