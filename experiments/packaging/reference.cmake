# SPDX-License-Identifier: GPL-3.0-or-later
# Target `docs`: the reference of the libraries, reference/html/index.html in the build folder. Only on demand.
find_program(KINEX_DOXYGEN doxygen)
find_program(KINEX_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(KINEX_PYTHON python3)
set(KINEX_REFERENCE_DIR ${PROJECT_BINARY_DIR}/reference)
if(KINEX_DOXYGEN AND KINEX_PYTHON)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/reference/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(docs COMMAND ${KINEX_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/reference/make.py ${KINEX_DOXYGEN}
      ${PROJECT_BINARY_DIR}/Doxyfile ${KINEX_REFERENCE_DIR}
    COMMENT "Making the reference of the libraries" VERBATIM)
else()
  add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E echo
      "kinex: the reference needs doxygen and python3: install them, then run cmake again"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
