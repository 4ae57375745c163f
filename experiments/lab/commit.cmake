# SPDX-License-Identifier: GPL-3.0-or-later
# Writes kinex_commit.h: the commit of the sources and whether they have been changed since.
#   cmake -DSOURCE=FOLDER -DOUTPUT=FILE -P commit.cmake
# The file is left alone when nothing has changed, so that nothing is compiled again.
cmake_minimum_required(VERSION 3.25)
set(commit unknown)
set(dirty 0)
find_program(GIT git)
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse HEAD OUTPUT_VARIABLE found
    RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT failed)
    set(commit ${found})
    # Of what the program is made of: documents that results are written to are none of it.
    execute_process(COMMAND ${GIT} -C ${SOURCE} status --porcelain --untracked-files=all --
        CMakeLists.txt core predicates structures experiments
        ":(exclude)*.md" ":(exclude)*.svg" ":(exclude)*.json" ":(exclude)*.jsonl"
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      set(dirty 1)
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "// Generated.
#define KINEX_COMMIT \"@commit@\"
#define KINEX_DIRTY @dirty@
" @ONLY)
