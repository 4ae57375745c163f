// SPDX-License-Identifier: GPL-3.0-or-later
// CsvColumns: the columns of a table by what they mean.
#ifndef KINEX_EXPERIMENTS_FORMATS_CSV_COLUMNS_H
#define KINEX_EXPERIMENTS_FORMATS_CSV_COLUMNS_H

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/formats/csv_table.h"

namespace kinex::formats {

// --column MEANING=COLUMN: the column of a meaning ("id", "t", "x", "vx", ..). Empty: the table has none.
struct NamedColumn {
  std::string meaning, column;
};

// What a column can mean, in the order of help texts: places and times, and what objects have beside them.
const std::vector<std::string>& meanings_of_places();
const std::vector<std::string>& meanings_of_objects();

class CsvColumns {
 public:
  // Throws InputError for a name that is no column of the table, and for a meaning or a column that is
  // named twice. All three must outlive this.
  CsvColumns(const CsvTable& table, const std::string& file, const std::vector<NamedColumn>& named);

  // The column for a meaning: that of --column, else that of this name, if it has no other meaning.
  std::optional<std::size_t> find(const std::string& meaning) const;
  // The same, and the column is used for it.
  std::optional<std::size_t> take(const std::string& meaning);
  // The same. Throws InputError with this remedy, in front of "or say which they are", if there is none.
  // `alternative`: a meaning that would do, too.
  std::size_t take_required(const std::string& meaning, const std::string& remedy,
                            const std::string& alternative = "");
  // The column is used for a meaning that has an option of its own.
  void use(std::size_t column, const std::string& meaning);
  bool is_used(std::size_t column) const { return used_[column]; }

  // By number.
  std::vector<std::size_t> unused() const;
  // The meaning that a column has by --column or by its name; empty: none.
  std::string meaning_of(std::size_t column) const;
  // True if it has that meaning by --column.
  bool is_named(std::size_t column) const;
  // " --column t=T" for every meaning whose column differs by capitals alone.
  std::string capitals() const;
  // "columns: id from trackId, t, x, y".
  std::string text() const;

 private:
  // The column whose name differs from a meaning by capitals alone.
  const std::string* in_capitals(const std::string& meaning) const;
  // What to do if a name of a column has another separator in it; otherwise empty.
  std::string other_separator() const;

  const CsvTable& table_;
  const std::string& file_;
  const std::vector<NamedColumn>& named_;
  std::vector<bool> used_;
  std::vector<std::pair<std::string, std::size_t>> taken_;  // in this order
};

}  // namespace kinex::formats

#endif
