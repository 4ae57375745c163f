# SPDX-License-Identifier: GPL-3.0-or-later
# What shells and man know of the program: its completions, and with help2man its man pages (target `man`). Both
# come from the built program, and are part of a whole build.
set(KINEX_COMPLETIONS ${PROJECT_BINARY_DIR}/completions)
set(completions)
foreach(shell bash zsh fish)
  add_custom_command(OUTPUT ${KINEX_COMPLETIONS}/kinex.${shell}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${KINEX_COMPLETIONS}
    COMMAND kinex completion ${shell} > ${KINEX_COMPLETIONS}/kinex.${shell}
    DEPENDS kinex VERBATIM)
  list(APPEND completions ${KINEX_COMPLETIONS}/kinex.${shell})
endforeach()
add_custom_target(completions ALL DEPENDS ${completions})
install(FILES ${KINEX_COMPLETIONS}/kinex.bash RENAME kinex OPTIONAL
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${KINEX_COMPLETIONS}/kinex.zsh RENAME _kinex OPTIONAL
  DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${KINEX_COMPLETIONS}/kinex.fish OPTIONAL
  DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

find_program(KINEX_HELP2MAN help2man)
set(KINEX_MAN ${PROJECT_BINARY_DIR}/man)
if(KINEX_HELP2MAN)
  add_custom_command(OUTPUT ${KINEX_MAN}/kinex.1
    COMMAND sh ${CMAKE_CURRENT_LIST_DIR}/man-pages $<TARGET_FILE:kinex> ${PROJECT_VERSION} ${KINEX_MAN}
    DEPENDS kinex ${CMAKE_CURRENT_LIST_DIR}/man-pages VERBATIM)
  add_custom_target(man ALL DEPENDS ${KINEX_MAN}/kinex.1)
else()
  add_custom_target(man COMMAND ${CMAKE_COMMAND} -E echo
      "kinex: man pages need help2man: install it, then run cmake again"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
install(DIRECTORY ${KINEX_MAN}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 OPTIONAL
  FILES_MATCHING PATTERN "*.1")
