# SPDX-License-Identifier: GPL-3.0-or-later
# Rooms: the folders of the second level, a static library each.
include_guard(GLOBAL)

# The library kinex_FOLDER_ROOM of FOLDER/ROOM/*.cpp, linked to what follows (PUBLIC .. PRIVATE ..). A room
# in a room, as families/hull, is kinex_FOLDER_families_hull. Those of experiments/ are the program's alone.
function(kinex_room folder room)
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/${room}/*.cpp)
  string(REPLACE "/" "_" name ${room})
  set(target kinex_${folder}_${name})
  # Audits include CGAL, and nothing else does: batches of their own. Alone: audits by CGAL's triangulations of points,
  # which have the same names; what is compiled anew for every commit; small rooms whose files define the same names in
  # their unnamed namespaces; members of a class template that another file instantiates as a whole.
  set(alone ${sources})
  set(audits)
  set(single core/numbers core/arithmetic core/engine predicates/bodies predicates/ccd)
  if(NOT ${folder}/${room} IN_LIST single)
    list(FILTER alone INCLUDE REGEX "/(delaunay|regular)_[23]_audit\\.cpp$|/machine\\.cpp$|/regular_hidden\\.cpp$")
    set(audits ${sources})
    list(REMOVE_ITEM audits ${alone} "")
    list(FILTER audits INCLUDE REGEX "_audit\\.cpp$")
  endif()
  list(REMOVE_ITEM sources ${alone} ${audits} "")
  set(size 6)
  if(folder STREQUAL experiments)
    set(size 8)
  endif()
  kinex_batches(batches ${target} ${size} ${sources})
  kinex_batches(audit_batches ${target}_audits 6 ${audits})
  add_library(${target} STATIC ${batches} ${audit_batches} ${alone})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/kinex>)
  target_link_libraries(${target} ${ARGN} PRIVATE $<BUILD_INTERFACE:kinex_warnings>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder}_${name} KINEX_ROOM ${folder}/${room})
  set(group rooms)
  if(CGAL::CGAL IN_LIST ARGN)  # which rounds in other ways
    set(group rooms_cgal)
  endif()
  # Under sanitizers clang takes far longer for optimised formulas and verbs, and tests gain no time by them.
  if(KINEX_SANITIZE AND (folder STREQUAL experiments OR ${folder}/${room} STREQUAL predicates/points))
    target_compile_options(${target} PRIVATE -O0)
    string(APPEND group _plain)
  endif()
  kinex_precompile(${target} ${group})
  if(NOT folder STREQUAL experiments)
    set_property(GLOBAL APPEND PROPERTY KINEX_ROOMS ${target})
  endif()
endfunction()

# kinex::FOLDER: these rooms together.
function(kinex_house folder)
  add_library(kinex_${folder} INTERFACE)
  add_library(kinex::${folder} ALIAS kinex_${folder})
  target_link_libraries(kinex_${folder} INTERFACE ${ARGN})
  set_target_properties(kinex_${folder} PROPERTIES EXPORT_NAME ${folder} KINEX_ROOM ${folder})
  if(NOT folder STREQUAL experiments)
    set_property(GLOBAL APPEND PROPERTY KINEX_ROOMS kinex_${folder})
  endif()
endfunction()

# Writes FILE: a line for each target below the folders that follow, "target|room|folder|sources|links|passed on". The
# room is that whose library it is, if any; sources are relative to the folder, or absolute; links are what it links
# itself, passed on is what it makes others link. tests/program/include_graph.py holds the includes to it.
function(kinex_write_links file)
  set(folders ${ARGN})
  set(text)
  while(folders)
    list(POP_FRONT folders folder)
    get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
    list(APPEND folders ${below})
    get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(target ${targets})
      set(line ${target})
      foreach(property KINEX_ROOM SOURCE_DIR SOURCES LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
        get_target_property(value ${target} ${property})
        if(NOT value)
          set(value)
        endif()
        string(APPEND line "|${value}")
      endforeach()
      string(APPEND text "${line}\n")
    endforeach()
  endwhile()
  file(CONFIGURE OUTPUT ${file} CONTENT "${text}" @ONLY)
endfunction()
