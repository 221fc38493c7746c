# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0

# nacre_embed(OUTPUT file.cpp ROOTS folder=prefix…)
#
# Adds a command that writes a C++ source with every file below the folders, under the name
# prefix + path below the folder, and writes it again when a file changes, comes or goes.
function(nacre_embed)
    cmake_parse_arguments(ARG "" "OUTPUT" "ROOTS" ${ARGN})
    set(list "")
    set(files "")
    foreach(root IN LISTS ARG_ROOTS)
        string(REGEX MATCH "^(.*)=(.*)$" _ "${root}")
        set(folder "${CMAKE_MATCH_1}")
        set(prefix "${CMAKE_MATCH_2}")
        file(GLOB_RECURSE found CONFIGURE_DEPENDS
             "${folder}/*.yml" "${folder}/*.csv" "${folder}/*.h" "${folder}/*.toml"
             "${folder}/*.py" "${folder}/*.osl" "${folder}/*.txt")
        foreach(file IN LISTS found)
            file(RELATIVE_PATH name "${folder}" "${file}")
            list(APPEND list "${prefix}${name}=${file}")
        endforeach()
        list(APPEND files ${found})
    endforeach()
    # By name in byte order, as find_resource() searches.
    list(SORT list COMPARE STRING CASE SENSITIVE)
    list(JOIN list "\n" list)
    file(CONFIGURE OUTPUT "${ARG_OUTPUT}.list" CONTENT "${list}\n" @ONLY)
    set(script "${PROJECT_SOURCE_DIR}/cpp_tools/cmake/WriteResources.cmake")
    add_custom_command(
        OUTPUT "${ARG_OUTPUT}"
        COMMAND "${CMAKE_COMMAND}" "-DLIST=${ARG_OUTPUT}.list" "-DOUTPUT=${ARG_OUTPUT}" -P "${script}"
        DEPENDS "${ARG_OUTPUT}.list" "${script}" ${files}
        COMMENT "Embedding resources"
        VERBATIM)
endfunction()
