# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the files of the page part of the program: cmake -DPAGE=FOLDER -DOUTPUT=FILE.cpp -P embed.cmake
# Each file becomes a string literal, in hexadecimal: so no character needs care.
function(embed name)
  set(text "")
  foreach(file ${ARGN})
    file(READ ${PAGE}/${file} content HEX)
    string(LENGTH "${content}" length)
    set(at 0)
    while(at LESS length)
      string(SUBSTRING "${content}" ${at} 96 part)
      string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" part "${part}")
      string(APPEND text "\n    \"${part}\"")
      math(EXPR at "${at} + 96")
    endwhile()
  endforeach()
  file(APPEND ${OUTPUT}.new "extern const std::string_view ${name};\nconst std::string_view ${name} =${text};\n")
endfunction()

file(WRITE ${OUTPUT}.new "#include <string_view>\n\nnamespace kinex::view {\n")
embed(kViewFrame page.html)
embed(kViewStyle style.css)
embed(kViewScript data.js numbers.js exact.js replay.js motion.js picture.js space.js marks.js framing.js plane.js queries.js diagram.js window.js
  panel.js proof.js figures.js walls.js axis.js tree.js bodies.js pairs.js chart.js arena.js lanes.js certificates.js
  pair_panel.js kinds.js root_picture.js filter.js main.js address.js export.js pointers.js start.js)
embed(kViewUnpack unpack.js)
file(APPEND ${OUTPUT}.new "}  // namespace kinex::view\n")
file(RENAME ${OUTPUT}.new ${OUTPUT})
