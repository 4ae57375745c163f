// SPDX-License-Identifier: GPL-3.0-or-later
// CsvTable: a CSV text (RFC 4180; the separator may be another) as rows of fields that know their line.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_TABLE_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_TABLE_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinex::formats {

struct CsvRow {
  std::size_t line;  // in the file, from 1
  std::vector<std::string> fields;
};

struct CsvTable {
  std::vector<std::string> columns;  // of the first line, blanks around the names removed
  std::vector<CsvRow> rows;          // each has as many fields as there are columns
  char separator = ',';

  std::optional<std::size_t> column(std::string_view name) const;
};

// Throws InputError for an empty file, a column named twice, a row with another number of fields
// than there are columns, a quote that is not closed, or lines that end with CR alone. Empty lines are
// skipped; CRLF is fine. Blanks around fields are removed, but not those in quotes.
// The separator is the one that stands most often in the first line, outside of quotes: a comma, a semicolon or
// a tab, in this order where two stand as often.
inline constexpr char kGuessedSeparator = '\0';
CsvTable parse_csv(std::string_view text, const std::string& file,
                   char separator = kGuessedSeparator);

// Throws InputError if a first line, of these fields, has values where names should be: half of them at least are numbers
// or dates, and none is "id".
void check_names(const std::vector<std::string>& names, char separator, const std::string& file);

// The fields of one row, without the blanks around them; `source` is for messages. A line end outside of quotes is refused.
std::vector<std::string> parse_csv_row(std::string_view text, const std::string& source);

}  // namespace kinex::formats

#endif
