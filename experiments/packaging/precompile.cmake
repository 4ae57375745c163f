# SPDX-License-Identifier: GPL-3.0-or-later
# Precompiled headers of the standard library and of the test framework: a third of the time of a build. The code does
# not know of them: it includes what it uses (tests/program/standard_includes.py), and -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
# builds it without.
include_guard(GLOBAL)

set(KINEX_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <span>
  <stdexcept> <string> <string_view> <utility> <vector>)

# kinex_precompile(TARGET GROUP HEADERS ..): the standard headers and these. The targets of a group have the same options
# and headers, and share what the first of them has compiled; their definitions mean nothing to those headers.
function(kinex_precompile target group)
  get_property(first GLOBAL PROPERTY KINEX_PRECOMPILED_${group})
  if(first)
    target_precompile_headers(${target} REUSE_FROM ${first})
  else()
    target_precompile_headers(${target} PRIVATE ${KINEX_STANDARD_HEADERS} ${ARGN})
    set_property(GLOBAL PROPERTY KINEX_PRECOMPILED_${group} ${target})
  endif()
  # Without these ccache takes no notice of such a header, or makes it anew for the time in it.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()
