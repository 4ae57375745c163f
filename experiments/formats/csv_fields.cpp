// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_fields.h"

#include <utility>

#include "experiments/formats/json_document.h"
#include "experiments/formats/number_defect.h"
#include "experiments/formats/scene_reader.h"
#include "experiments/formats/utf8.h"

namespace kinex::formats {

std::string place_of_row(const CsvRow& row) { return "line " + std::to_string(row.line); }

std::string csv_number_remedy(std::string_view field) {
  if (field.find(',') == field.npos) return kCsvNumberRemedy;
  const bool thousands = field.find('.') != field.npos || field.find(',') != field.rfind(',');
  return std::string("write decimals with a point, not with a comma") +
         (thousands ? ", and nothing between thousands" : "");
}

std::optional<Rational> csv_number(const std::string& field) {
  if (field.size() > kMaxNumberLength) return std::nullopt;
  return Rational::parse(field);
}

Rational csv_number(const CsvTable& table, const CsvRow& row, std::size_t column,
                    const std::string& file) {
  const std::string& field = row.fields[column];
  if (std::optional<Rational> value = csv_number(field)) return *std::move(value);
  const NumberDefect defect = number_defect(field, csv_number_remedy(field));
  throw InputError(
      file, place_of_row(row),
      show_text(field) + " in column " + show_text(table.columns[column]) + " " + defect.problem,
      defect.remedy);
}

void check_csv_id(const std::string& id, const std::string& file, const std::string& where) {
  if (id.empty()) throw InputError(file, where, "an empty id", "write a name");
  if (!is_utf8(id)) {
    throw InputError(file, where, "the id " + show_text(id) + " is not UTF-8",
                     "convert the file to UTF-8");
  }
  if (id.size() > kMaxIdLength && characters(id) > kMaxIdLength) {
    throw InputError(file, where, "an id of " + std::to_string(characters(id)) + " characters",
                     "write at most 1000");
  }
}

std::string remedy_without_line(const InputError& error) {
  return error.remedy().substr(0, error.remedy().rfind(" (line "));
}

}  // namespace kinex::formats
