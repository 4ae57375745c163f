# SPDX-License-Identifier: GPL-3.0-or-later
# Debian packages by CPack: kinex (the program) and libkinex-dev (headers, static libraries, find_package). Made
# and tried by packaging/deb/make and packaging/deb/try.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kinex)
set(CPACK_PACKAGE_VENDOR "The kinex developers")
set(CPACK_PACKAGE_CONTACT "The kinex developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME kinex)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "kinex runs kinetic data structures over moving objects with exact event times,
counts every event, checks every bound, audits every run against an
independent static computation, and measures what floating-point arithmetic
would have got wrong.
.
This package has the program, its man pages and completions, the second
program that checks event logs, schemas, and example scenes and plans.")
# The libraries that the program is linked with: dpkg-shlibdeps knows their packages.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "python3:any")  # kinex-logcheck
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkinex-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "Headers and static libraries of kinex: exact numbers and instants, the
simulator of kinetic data structures, predicates, and the structures. C++20
projects find them with find_package(kinex).")
# What the headers include, what the libraries are linked with, and what find_package(kinex) looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libgmp-dev, libmpfr-dev, libgsl-dev, libcgal-dev, libboost-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "kinex, cmake, g++")

# What every package of Debian's has beside its files; its date is that of the release.
set(papers ${PROJECT_BINARY_DIR}/deb)
file(STRINGS ${PROJECT_SOURCE_DIR}/CITATION.cff released REGEX "^date-released:")
string(REGEX REPLACE "^date-released: *" "" released "${released}")
execute_process(COMMAND date -u -R -d ${released} OUTPUT_VARIABLE KINEX_DATE
  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
configure_file(${CMAKE_CURRENT_LIST_DIR}/copyright ${papers}/copyright COPYONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${papers}/changelog @ONLY)
foreach(package kinex libkinex-dev)
  set(component program)
  if(package STREQUAL libkinex-dev)
    set(component development)
  endif()
  # Only in packages: an installation by hand has LICENSE.
  install(FILES ${papers}/copyright ${papers}/changelog DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/tidy.cmake)
if(KINEX_DEVELOPER)
  set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)  # packages of what is built, without building all tests
endif()
include(CPack)
