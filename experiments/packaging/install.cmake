# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, and find_package(kinex) afterwards: kinex::core, kinex::predicates, kinex::structures.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(KINEX_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/kinex)
install(TARGETS kinex_core kinex_predicates kinex_structures kinex_options EXPORT kinexTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS kinex RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(folder core predicates structures)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kinex
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/experiments/schemas ${PROJECT_SOURCE_DIR}/experiments/scenes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(EXPORT kinexTargets NAMESPACE kinex:: DESTINATION ${KINEX_CMAKE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/kinexConfig.cmake.in
  ${PROJECT_BINARY_DIR}/kinexConfig.cmake INSTALL_DESTINATION ${KINEX_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kinexConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kinexConfig.cmake ${PROJECT_BINARY_DIR}/kinexConfigVersion.cmake
  DESTINATION ${KINEX_CMAKE_DIR})
