// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_columns.h"

#include <algorithm>
#include <cctype>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"

namespace kinex::formats {

namespace {

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

const std::vector<std::string>& meanings_of_places() {
  static const std::vector<std::string> meanings{"id", "t", "x", "y", "z", "vx", "vy", "vz"};
  return meanings;
}

const std::vector<std::string>& meanings_of_objects() {
  static const std::vector<std::string> meanings{"radius",  "weight",  "hx",  "hy",  "hz",
                                                 "vradius", "vweight", "vhx", "vhy", "vhz",
                                                 "colour",  "from",    "to",  "line"};
  return meanings;
}

CsvColumns::CsvColumns(const CsvTable& table, const std::string& file,
                       const std::vector<NamedColumn>& named)
    : table_(table), file_(file), named_(named), used_(table.columns.size()) {
  for (std::size_t i = 0; i < named_.size(); ++i) {
    const NamedColumn& one = named_[i];
    if (!one.column.empty() && !table_.column(one.column)) {
      check_names(table_.columns, table_.separator, file_);
      throw InputError(
          file_, "line 1",
          "there is no column " + show_text(one.column) + ", that of --column " + one.meaning,
          did_you_mean(one.column, table_.columns, "name a column of the table"));
    }
    for (std::size_t j = 0; j < i; ++j) {
      const bool same_column = named_[j].column == one.column && !one.column.empty();
      if (named_[j].meaning != one.meaning && !same_column) continue;
      throw InputError(
          "--column", "",
          one.meaning + "=" + one.column + " after " + named_[j].meaning + "=" + named_[j].column,
          "give every meaning one column of its own");
    }
  }
}

std::optional<std::size_t> CsvColumns::find(const std::string& meaning) const {
  for (const NamedColumn& one : named_) {
    if (one.meaning != meaning) continue;
    return one.column.empty() ? std::nullopt : table_.column(one.column);
  }
  for (const NamedColumn& one : named_) {
    if (one.column == meaning) return std::nullopt;
  }
  return table_.column(meaning);
}

std::optional<std::size_t> CsvColumns::take(const std::string& meaning) {
  const std::optional<std::size_t> found = find(meaning);
  if (found) use(*found, meaning);
  return found;
}

std::size_t CsvColumns::take_required(const std::string& meaning, const std::string& remedy,
                                      const std::string& alternative) {
  if (const std::optional<std::size_t> found = take(meaning)) return *found;
  const std::string wanted = alternative.empty() ? meaning : alternative;
  for (const std::string& capital : {wanted, meaning}) {
    if (in_capitals(capital) == nullptr) continue;
    throw InputError(
        file_, "line 1",
        "there is no column " + show_text(capital) + " in small letters; capitals matter",
        "write the names in small letters, or give" + capitals());
  }
  if (taken_.empty()) check_names(table_.columns, table_.separator, file_);
  const std::string none = alternative.empty() ? "" : ", and none " + show_text(meaning);
  throw InputError(
      file_, "line 1", "there is no column " + show_text(wanted) + none,
      remedy + ", or say which they are: --column " + wanted + "=NAME" + other_separator());
}

void CsvColumns::use(std::size_t column, const std::string& meaning) {
  used_[column] = true;
  taken_.emplace_back(meaning, column);
}

std::vector<std::size_t> CsvColumns::unused() const {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) columns.push_back(i);
  }
  return columns;
}

std::string CsvColumns::meaning_of(std::size_t column) const {
  for (const std::vector<std::string>* meanings : {&meanings_of_places(), &meanings_of_objects()}) {
    for (const std::string& meaning : *meanings) {
      if (find(meaning) == column) return meaning;
    }
  }
  return {};
}

bool CsvColumns::is_named(std::size_t column) const {
  return std::any_of(named_.begin(), named_.end(), [&](const NamedColumn& one) {
    return !one.column.empty() && one.column == table_.columns[column];
  });
}

const std::string* CsvColumns::in_capitals(const std::string& meaning) const {
  if (find(meaning)) return nullptr;
  for (const NamedColumn& one : named_) {
    if (one.meaning == meaning) return nullptr;
  }
  for (std::size_t i = 0; i < table_.columns.size(); ++i) {
    const std::string& name = table_.columns[i];
    if (name != meaning && in_small_letters(name) == meaning && !is_named(i)) return &name;
  }
  return nullptr;
}

std::string CsvColumns::capitals() const {
  std::string options;
  for (const std::vector<std::string>* meanings : {&meanings_of_places(), &meanings_of_objects()}) {
    for (const std::string& meaning : *meanings) {
      const std::string* const name = in_capitals(meaning);
      if (name != nullptr) options += " --column " + meaning + "=" + *name;
    }
  }
  return options;
}

std::string CsvColumns::other_separator() const {
  for (const auto& [separator, name] :
       {std::pair(';', "semicolon"), {'\t', "tab"}, {',', "comma"}}) {
    for (const std::string& column : table_.columns) {
      if (separator == table_.separator || column.find(separator) == std::string::npos) continue;
      return ", or give --separator " + std::string(name) + " if " + show_text(column) +
             " is more than one name";
    }
  }
  return {};
}

std::string CsvColumns::text() const {
  std::string meanings;
  for (const auto& [meaning, column] : taken_) {
    meanings += (meanings.empty() ? "columns: " : ", ") + meaning;
    if (table_.columns[column] != meaning) meanings += " from " + table_.columns[column];
  }
  return meanings;
}

}  // namespace kinex::formats
