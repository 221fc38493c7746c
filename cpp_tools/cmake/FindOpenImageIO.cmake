# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
#
# Defines OpenImageIO::OpenImageIO. From 3.0 on OpenImageIO's own CMake package is used. That of 2.x
# names files which distributions do not pull in with it (Debian 12: Imath's Python library and
# OpenCV's headers) and stops the configuration over them, so pkg-config comes first there.

include(FindPackageHandleStandardArgs)

if(TARGET OpenImageIO::OpenImageIO)
    set(OpenImageIO_FOUND TRUE)
    return()
endif()

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
    pkg_check_modules(PC_OpenImageIO QUIET IMPORTED_TARGET OpenImageIO)
endif()

if(PC_OpenImageIO_FOUND AND PC_OpenImageIO_VERSION VERSION_LESS 3.0)
    add_library(OpenImageIO::OpenImageIO INTERFACE IMPORTED)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
                          INTERFACE_LINK_LIBRARIES PkgConfig::PC_OpenImageIO)
    set(OpenImageIO_VERSION "${PC_OpenImageIO_VERSION}")
    set(OpenImageIO_SOURCE "pkg-config")
else()
    find_package(OpenImageIO CONFIG QUIET)
    set(OpenImageIO_SOURCE "${OpenImageIO_DIR}")
endif()

find_package_handle_standard_args(OpenImageIO
    REQUIRED_VARS OpenImageIO_SOURCE VERSION_VAR OpenImageIO_VERSION
    REASON_FAILURE_MESSAGE "install libopenimageio-dev, or build with -DNACRE_BUILD_TOOL=OFF")
