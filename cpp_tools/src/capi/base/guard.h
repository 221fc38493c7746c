// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "nacre/capi/base.h"
#include "nacre/core/diagnostics.h"

namespace nacre::capi {

/// Text of the calling thread's last failure.
void set_last_error(const char* message) noexcept;

/// Runs `body` and turns what it throws into a status: the border that no exception crosses.
template <class Body>
nacre_status guarded(Body&& body) noexcept
{
    try {
        body();
        return NACRE_OK;
    } catch (const InputError& error) {
        set_last_error(error.what());
        return NACRE_INPUT;
    } catch (const std::bad_alloc&) {
        set_last_error("out of memory");
        return NACRE_MEMORY;
    } catch (const std::exception& error) {
        set_last_error(error.what());
        return NACRE_INTERNAL;
    } catch (...) {
        set_last_error("unknown error");
        return NACRE_INTERNAL;
    }
}

[[noreturn]] inline void fail(std::string field, std::string message)
{
    throw InputError(Diagnostic{{}, 0, std::move(field), std::move(message)});
}

/// @throws InputError when a required pointer is null
inline void require(const void* pointer, const char* field)
{
    if (pointer == nullptr) fail(field, "must not be null");
}

inline std::string text_or_empty(const char* text)
{
    return text == nullptr ? std::string() : std::string(text);
}

/// Runs `solve` for each item; what it throws says which one.
template <class Solve>
void for_each_item(std::size_t count, Solve&& solve)
{
    for (std::size_t i = 0; i < count; ++i) {
        try {
            solve(i);
        } catch (const InputError& error) {
            std::vector<Diagnostic> problems(error.diagnostics().begin(),
                                             error.diagnostics().end());
            for (Diagnostic& problem : problems) problem.message += fmt::format(" (item {})", i);
            throw InputError(std::move(problems));
        }
    }
}

}  // namespace nacre::capi
