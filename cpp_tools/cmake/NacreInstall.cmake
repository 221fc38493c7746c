# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0

# Headers and the package that `find_package(Nacre)` finds. Include it after every exported target.
include(CMakePackageConfigHelpers)

set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Nacre")
configure_package_config_file(
    "${CMAKE_CURRENT_LIST_DIR}/NacreConfig.cmake.in" "${PROJECT_BINARY_DIR}/NacreConfig.cmake"
    INSTALL_DESTINATION "${package_destination}" NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/NacreConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/cpp_tools/include/nacre"
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.h")
install(EXPORT NacreTargets NAMESPACE Nacre:: DESTINATION "${package_destination}")
install(FILES "${PROJECT_BINARY_DIR}/NacreConfig.cmake"
              "${PROJECT_BINARY_DIR}/NacreConfigVersion.cmake"
              "${CMAKE_CURRENT_LIST_DIR}/FindLibYAML.cmake"
        DESTINATION "${package_destination}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/cpp_tools/THIRD_PARTY.md"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}")
