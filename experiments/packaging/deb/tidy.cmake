# SPDX-License-Identifier: GPL-3.0-or-later
# Debian's ways, before the packages are made: man pages and changelogs are compressed, the licence is named in
# `copyright` and not there again, and zsh looks for what packages bring in a folder of its own.
foreach(pattern share/man/man1/*.1 share/doc/*/changelog)
  file(GLOB_RECURSE pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/${pattern})
  if(pages)
    execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
file(GLOB licences ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*/LICENSE)
if(licences)
  file(REMOVE ${licences})
endif()
file(GLOB folders ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/zsh)
foreach(folder ${folders})
  file(RENAME ${folder}/site-functions ${folder}/vendor-completions)
endforeach()
