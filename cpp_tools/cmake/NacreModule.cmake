# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0

# Flags for our own sources only; consumers never inherit them.
add_library(nacre_flags INTERFACE)
target_compile_features(nacre_flags INTERFACE cxx_std_20)
# -ffp-contract=off keeps results equal on machines with and without fused multiply-add.
# GCC 12 warns about std::string's own memcpy: https://gcc.gnu.org/bugzilla/show_bug.cgi?id=105329
target_compile_options(nacre_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
    $<$<BOOL:${NACRE_WARNINGS_AS_ERRORS}>:-Werror>)

# The modules, each after those that it depends on, and the only arrows between them: a module sees
# the headers of what is named here, and no others. tests/lint/includes.py reads this table as well.
set(NACRE_MODULES core spectral media readers library bands textures optics lut material oslgen kinds pipeline)
set(NACRE_DEPENDS_core "")
set(NACRE_DEPENDS_spectral core)
set(NACRE_DEPENDS_media spectral)
set(NACRE_DEPENDS_readers media)
set(NACRE_DEPENDS_library readers)
set(NACRE_DEPENDS_bands library)
set(NACRE_DEPENDS_textures media)
set(NACRE_DEPENDS_optics media)
set(NACRE_DEPENDS_lut optics)
set(NACRE_DEPENDS_material core)
set(NACRE_DEPENDS_oslgen material)
set(NACRE_DEPENDS_kinds library lut oslgen)
set(NACRE_DEPENDS_pipeline kinds)

# nacre_unity(TARGET SIZE)
#
# With NACRE_UNITY, compiles the sources of the target SIZE at a time. Sources with options or
# definitions of their own stay by themselves.
function(nacre_unity target size)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${NACRE_UNITY} UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# nacre_sources(VARIABLE)
#
# All C++ sources of the folder and what is below it: a file that comes or goes costs no edit.
function(nacre_sources variable)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    set(${variable} "${found}" PARENT_SCOPE)
endfunction()

# nacre_module(NAME [SOURCES file…] [LIBRARIES target…])
#
# Adds the static library nacre_NAME (alias Nacre::NAME) from src/NAME, and from files that are made.
# Each module sees the public headers of itself and of what NACRE_DEPENDS_NAME has and nothing else:
# every module has an include folder of its own in the build tree that links to include/nacre/NAME.
function(nacre_module name)
    cmake_parse_arguments(ARG "" "" "SOURCES;LIBRARIES" ${ARGN})
    foreach(dependency IN LISTS NACRE_DEPENDS_${name})
        if(NOT TARGET nacre_${dependency})
            message(FATAL_ERROR "module ${name} depends on ${dependency}, "
                                "which must stand before it in NACRE_MODULES")
        endif()
    endforeach()

    set(view "${PROJECT_BINARY_DIR}/module_include/${name}")
    file(MAKE_DIRECTORY "${view}/nacre")
    file(CREATE_LINK "${PROJECT_SOURCE_DIR}/cpp_tools/include/nacre/${name}" "${view}/nacre/${name}"
         SYMBOLIC)

    nacre_sources(sources)
    add_library(nacre_${name} STATIC ${sources} ${ARG_SOURCES})
    add_library(Nacre::${name} ALIAS nacre_${name})
    list(TRANSFORM NACRE_DEPENDS_${name} PREPEND Nacre:: OUTPUT_VARIABLE module_targets)
    target_link_libraries(nacre_${name} PUBLIC ${module_targets} PRIVATE ${ARG_LIBRARIES}
                          $<BUILD_INTERFACE:nacre_flags>)
    target_include_directories(nacre_${name} PUBLIC
        $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
        PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    target_compile_features(nacre_${name} PUBLIC cxx_std_20)
    set_target_properties(nacre_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name})
    nacre_unity(nacre_${name} 24)
    # Readers of files call nothing of these but are linked with them: a third of the fuzzers' build.
    if(NACRE_BUILD_FUZZERS AND name MATCHES "^(optics|lut)$")
        target_compile_options(nacre_${name} PRIVATE -O0 -fno-sanitize=all)
    endif()
    install(TARGETS nacre_${name} EXPORT NacreTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()
