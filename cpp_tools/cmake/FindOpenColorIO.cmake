# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
#
# Defines OpenColorIO::OpenColorIO from OpenColorIO's own CMake package where there is one, else from
# pkg-config (Debian 12 ships only OpenColorIO.pc).

include(FindPackageHandleStandardArgs)

if(TARGET OpenColorIO::OpenColorIO)
    set(OpenColorIO_FOUND TRUE)
    return()
endif()

find_package(OpenColorIO CONFIG QUIET)
if(OpenColorIO_FOUND)
    set(OpenColorIO_SOURCE "${OpenColorIO_DIR}")
else()
    find_package(PkgConfig QUIET)
    if(PkgConfig_FOUND)
        pkg_check_modules(PC_OpenColorIO QUIET IMPORTED_TARGET OpenColorIO)
    endif()
    if(PC_OpenColorIO_FOUND)
        add_library(OpenColorIO::OpenColorIO INTERFACE IMPORTED)
        set_target_properties(OpenColorIO::OpenColorIO PROPERTIES
                              INTERFACE_LINK_LIBRARIES PkgConfig::PC_OpenColorIO)
        set(OpenColorIO_VERSION "${PC_OpenColorIO_VERSION}")
        set(OpenColorIO_SOURCE "pkg-config")
    endif()
endif()

find_package_handle_standard_args(OpenColorIO
    REQUIRED_VARS OpenColorIO_SOURCE VERSION_VAR OpenColorIO_VERSION
    REASON_FAILURE_MESSAGE "install libopencolorio-dev, or build with -DNACRE_BUILD_TOOL=OFF")
