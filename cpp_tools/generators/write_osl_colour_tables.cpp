// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0

/// @file
/// Prints osl/include/nacre/nacre_colour_tables.h:
///   cmake --build build/release --target write_osl_colour_tables
///   build/release/write_osl_colour_tables > osl/include/nacre/nacre_colour_tables.h
/// The pipeline's tests compare the file with what this prints.

#include <cstdio>
#include <string>

#include "nacre/pipeline/shader_tables.h"

int main()
{
    const std::string text = nacre::pipeline::colour_tables_header();
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
