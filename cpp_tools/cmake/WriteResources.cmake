# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0

# Run by nacre_embed(): cmake -DLIST=file -DOUTPUT=file.cpp -P WriteResources.cmake
# Raw string literals: quick to write and to compile, and readable when something is wrong.
file(STRINGS "${LIST}" entries)
set(delimiter "nacre_file")
file(WRITE "${OUTPUT}.new" "// Written by WriteResources.cmake.
#include \"embedded_files.h\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"

namespace nacre {

using namespace std::string_view_literals;

static constexpr EmbeddedFile kFiles[] = {
")
foreach(entry IN LISTS entries)
    string(REGEX MATCH "^([^=]*)=(.*)$" _ "${entry}")
    set(name "${CMAKE_MATCH_1}")
    file(READ "${CMAKE_MATCH_2}" text)
    if(text MATCHES "\r|\\)${delimiter}\"")
        message(FATAL_ERROR "${name}: cannot be embedded (CR line ends, or the literal's delimiter)")
    endif()
    file(APPEND "${OUTPUT}.new" "{\"${name}\"sv, R\"${delimiter}(${text})${delimiter}\"sv},\n")
endforeach()
file(APPEND "${OUTPUT}.new" "};

std::span<const EmbeddedFile> embedded_files() noexcept { return kFiles; }

}  // namespace nacre
")
file(RENAME "${OUTPUT}.new" "${OUTPUT}")
