// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0

/// @file
/// Prints headers of osl/include/nacre that C++ has the truth of:
///   cmake --build build/release --target write_osl_headers
///   build/release/write_osl_headers colour_tables > osl/include/nacre/nacre_colour_tables.h
///   build/release/write_osl_headers constants > osl/include/nacre/nacre_constants.h
/// Tests of the kinds compare the files with what this prints.

#include <cstdio>
#include <string>
#include <string_view>

#include "nacre/kinds/shader_tables.h"

int main(int count, char** arguments)
{
    using namespace nacre::kinds;
    const std::string_view header = count == 2 ? arguments[1] : "";
    std::string text;
    if (header == "colour_tables")
        text = colour_tables_header(default_colour_weights());
    else if (header == "constants")
        text = constants_header();
    else
        return 1;
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
