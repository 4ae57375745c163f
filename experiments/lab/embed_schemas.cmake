# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the schemas of the databases part of the program:
#   cmake -DSCHEMAS=FOLDER -DOUTPUT=FILE.cpp -P embed_schemas.cmake
file(WRITE ${OUTPUT}.new "#include \"experiments/lab/result_database.h\"\n\nnamespace kinex::lab {\n")
foreach(name verify trade sweep)
  file(READ ${SCHEMAS}/${name}.sql text)
  file(APPEND ${OUTPUT}.new "\nstd::string_view ${name}_schema() {\n  return R\"sql(${text})sql\";\n}\n")
endforeach()
file(APPEND ${OUTPUT}.new "\n}  // namespace kinex::lab\n")
file(RENAME ${OUTPUT}.new ${OUTPUT})
