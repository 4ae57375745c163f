# SPDX-License-Identifier: GPL-3.0-or-later
# cmake --install, and find_package(kinex) afterwards: kinex::core, kinex::predicates, kinex::structures.
# Two components, which are the two Debian packages: program (kinex; what names none) and development
# (libkinex-dev).
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(KINEX_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/kinex)
get_property(rooms GLOBAL PROPERTY KINEX_ROOMS)
install(TARGETS ${rooms} kinex_options EXPORT kinexTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(TARGETS kinex RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
foreach(folder core predicates structures)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/kinex
    COMPONENT development FILES_MATCHING PATTERN "*.h")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/experiments/schemas ${PROJECT_SOURCE_DIR}/experiments/scenes
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex OPTIONAL)
# Sweeps: example plans, and scripts for machines of many nodes.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/experiments/sweep/plans ${PROJECT_SOURCE_DIR}/experiments/cluster
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex USE_SOURCE_PERMISSIONS)
# What reads results in Python, with its examples.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/experiments/python DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex
  PATTERN __pycache__ EXCLUDE)
# What makes pictures and animations of a page of kinex view.
install(FILES ${PROJECT_SOURCE_DIR}/experiments/view/animate.py ${PROJECT_SOURCE_DIR}/experiments/view/devtools.py
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex/view)
# The second program that checks logs: a folder of Python, and a script that starts it.
file(GLOB logcheck ${PROJECT_SOURCE_DIR}/experiments/logcheck/*.py)
install(FILES ${logcheck} ${PROJECT_SOURCE_DIR}/experiments/logcheck/README.md
  DESTINATION ${CMAKE_INSTALL_DATADIR}/kinex/logcheck)
file(RELATIVE_PATH KINEX_LOGCHECK_RELATIVE ${CMAKE_INSTALL_FULL_BINDIR}
  ${CMAKE_INSTALL_FULL_DATADIR}/kinex/logcheck)
configure_file(${PROJECT_SOURCE_DIR}/experiments/logcheck/kinex-logcheck.in
  ${PROJECT_BINARY_DIR}/kinex-logcheck @ONLY)
install(PROGRAMS ${PROJECT_BINARY_DIR}/kinex-logcheck DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
if(NOT KINEX_SANITIZE)  # where the program takes long, and nothing is installed
  include(${CMAKE_CURRENT_LIST_DIR}/manual.cmake)
endif()
install(EXPORT kinexTargets NAMESPACE kinex:: DESTINATION ${KINEX_CMAKE_DIR} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/kinexConfig.cmake.in
  ${PROJECT_BINARY_DIR}/kinexConfig.cmake INSTALL_DESTINATION ${KINEX_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/kinexConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/kinexConfig.cmake ${PROJECT_BINARY_DIR}/kinexConfigVersion.cmake
  DESTINATION ${KINEX_CMAKE_DIR} COMPONENT development)
include(${CMAKE_CURRENT_LIST_DIR}/reference.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/deb/deb.cmake)
