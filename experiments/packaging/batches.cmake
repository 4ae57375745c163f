# SPDX-License-Identifier: GPL-3.0-or-later
# Several sources compiled as one: their headers take longer than their code, and a clean build a third of the time.
# CMake's own unity builds include files by absolute paths, which ccache cannot share with a clone in another folder;
# these include them as the project's files include each other. -DKINEX_BATCHES=OFF compiles every file by itself.
#
# Two files of a batch must not have one name in their unnamed namespaces: rename one. A file of tests has a namespace
# of its own for its helpers.
include_guard(GLOBAL)
option(KINEX_BATCHES "Compile several sources as one" ON)

# kinex_batches(RESULT TARGET SIZE SOURCES ..): sets RESULT to the sources that TARGET is to be made of, batches of SIZE
# for SOURCES, which are absolute and below the project's folder.
function(kinex_batches result target size)
  if(NOT KINEX_BATCHES)
    set(${result} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(sources ${ARGN})
  list(SORT sources)
  list(LENGTH sources count)
  set(batches)
  set(begin 0)
  while(begin LESS count)
    list(SUBLIST sources ${begin} ${size} batch)
    set(text)
    foreach(source ${batch})
      cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
      string(APPEND text "#include \"${source}\"\n")
    endforeach()
    math(EXPR number "${begin} / ${size}")
    set(file ${CMAKE_CURRENT_BINARY_DIR}/batches/${target}_${number}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
    list(APPEND batches ${file})
    math(EXPR begin "${begin} + ${size}")
  endwhile()
  set(${result} ${batches} PARENT_SCOPE)
endfunction()
