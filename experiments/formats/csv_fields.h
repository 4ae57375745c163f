// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a CSV table as ids and exact numbers.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_FIELDS_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_FIELDS_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/numbers/rational.h"
#include "experiments/formats/csv_table.h"
#include "experiments/formats/input_error.h"

namespace kinex::formats {

inline constexpr const char* kCsvNumberRemedy = "write an integer, a fraction 1/3 or a decimal";
// The same for a field that is none; of its commas, if it has some.
std::string csv_number_remedy(std::string_view field);

// "line 7".
std::string place_of_row(const CsvRow& row);

// A number as in scenes; nullopt if `field` is none.
std::optional<Rational> csv_number(const std::string& field);
// The number in a column. Throws InputError that names file, line and column.
Rational csv_number(const CsvTable& table, const CsvRow& row, std::size_t column,
                    const std::string& file);

// Checks that an id of a table is a valid id of a scene. Throws InputError.
void check_csv_id(const std::string& id, const std::string& file, const std::string& where);

// The remedy of an error that the scene reader found in a text made from a table, without the line
// number of that text.
std::string remedy_without_line(const InputError& error);

}  // namespace kinex::formats

#endif
