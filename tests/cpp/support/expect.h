// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <complex>
#include <string>

#include "nacre/core/diagnostics.h"

/// Both parts within `tolerance`.
#define EXPECT_COMPLEX_NEAR(actual, expected, tolerance)                              \
    do {                                                                              \
        const std::complex<double> actual_ = (actual), expected_ = (expected);        \
        EXPECT_NEAR(actual_.real(), expected_.real(), tolerance) << "real part";      \
        EXPECT_NEAR(actual_.imag(), expected_.imag(), tolerance) << "imaginary part"; \
    } while (false)

namespace nacre::test {

/// What an InputError says that `call` throws; fails where it throws nothing or another thing.
template <typename Call>
std::string input_error_of(Call&& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    } catch (const std::exception& error) {
        ADD_FAILURE() << "threw another exception: " << error.what();
        return {};
    }
    ADD_FAILURE() << "threw nothing";
    return {};
}

}  // namespace nacre::test

/// `statement` throws an InputError with `part` in its text.
#define EXPECT_INPUT_ERROR(statement, part)                                          \
    do {                                                                             \
        const std::string text_ = ::nacre::test::input_error_of([&] { statement; }); \
        EXPECT_NE(text_.find(part), std::string::npos)                               \
            << "message: " << text_ << "\nexpected in it: " << (part);               \
    } while (false)
