// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/csv_table.h"

#include <algorithm>
#include <utility>

#include "core/numbers/rational.h"
#include "experiments/formats/counted.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/iso_time.h"
#include "experiments/formats/json_document.h"
#include "experiments/formats/utf8.h"

namespace kinex::formats {

namespace {

class CsvParser {
 public:
  CsvParser(std::string_view text, const std::string& file, char separator)
      : text_(text), file_(file), separator_(separator) {}

  // The next row with at least one character; false at the end.
  bool next(CsvRow& row) {
    while (at_ < text_.size()) {
      row.line = line_;
      row.fields.clear();
      begin_ = at_;
      read_row(row);
      if (row.fields.size() > 1 || !row.fields[0].empty()) return true;
    }
    return false;
  }
  // The last row as it is written, without its end.
  std::string_view row_text() const {
    std::string_view text = text_.substr(begin_, at_ - begin_);
    while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
    return text;
  }

 private:
  bool at_line_end() const {
    return at_ >= text_.size() || text_[at_] == '\n' || text_.substr(at_, 2) == "\r\n";
  }

  void read_row(CsvRow& row) {
    for (;;) {
      skip_blanks();
      row.fields.push_back(at_ < text_.size() && text_[at_] == '"' ? quoted_field()
                                                                   : plain_field());
      if (at_line_end()) break;
      ++at_;  // the separator
    }
    if (at_ < text_.size()) at_ += text_[at_] == '\r' ? 2 : 1;
    ++line_;
  }

  bool at_blank() const {
    return at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t') && text_[at_] != separator_;
  }
  void skip_blanks() {
    while (at_blank()) ++at_;
  }

  std::string plain_field() {
    const std::size_t begin = at_;
    std::size_t end = at_;  // after its last character that is no blank
    for (; !at_line_end() && text_[at_] != separator_; ++at_) {
      if (!at_blank()) end = at_ + 1;
    }
    return std::string(text_.substr(begin, end - begin));
  }

  std::string quoted_field() {
    const std::size_t first_line = line_;
    std::string field;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        ++at_;
        if (at_ >= text_.size() || text_[at_] != '"') {
          skip_blanks();
          if (at_line_end() || text_[at_] == separator_) return field;
          fail(line_, "text after a closing quote", "double quotes inside quotes");
        }
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    fail(first_line, "a quote is not closed", "close it");
  }

  [[noreturn]] void fail(std::size_t line, const char* problem, const char* remedy) const {
    throw InputError(file_, "line " + std::to_string(line), problem, remedy);
  }

  std::string_view text_;
  const std::string& file_;
  char separator_;
  std::size_t begin_ = 0, at_ = 0;
  std::size_t line_ = 1;
};

// Of the first line, quotes aside; tabs behind another separator are blanks.
char separator_of(std::string_view text) {
  bool quoted = false;
  std::size_t commas = 0, semicolons = 0, tabs = 0;
  char last = '\t';
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (c == '\n' && !quoted) break;
    if (quoted || c == ' ') continue;
    if (c == ',') ++commas;
    if (c == ';') ++semicolons;
    if (c == '\t' && last != ',' && last != ';' && last != '\t') ++tabs;
    last = c;
  }
  if (commas >= semicolons && commas >= tabs) return ',';
  return semicolons >= tabs ? ';' : '\t';
}

std::string separator_name(char separator) {
  return separator == ',' ? "comma" : separator == ';' ? "semicolon" : "tab";
}

// What to do about a row with another number of fields than there are columns.
std::string remedy_for_fields(const CsvRow& row, std::string_view text, const CsvTable& table) {
  const auto has = [&](char separator) {
    return std::any_of(
        table.columns.begin(), table.columns.end(),
        [separator](const std::string& name) { return name.find(separator) != name.npos; });
  };
  const std::size_t columns = table.columns.size();
  for (const char other : {',', ';', '\t'}) {
    if (other == table.separator || columns < 2) continue;
    const auto count = static_cast<std::size_t>(std::count(text.begin(), text.end(), other));
    if (count + 1 < columns) continue;
    return "separate its fields by " + separator_name(table.separator) + "s, as those of line 1" +
           (has(other) ? ", or give --separator " + separator_name(other) : "");
  }
  if (row.fields.size() < columns) return "write one field per column";
  return "write one field per column, text with a " + separator_name(table.separator) +
         " in quotes" + (table.separator == ',' ? ", decimals with a point" : "");
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

}  // namespace

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  const auto at = std::find(columns.begin(), columns.end(), name);
  if (at == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(at - columns.begin());
}

void check_names(const std::vector<std::string>& names, char separator, const std::string& file) {
  std::string line, problem;
  std::size_t values = 0;
  for (const std::string& name : names) {
    if (name == "id") return;
    line += (line.empty() ? "" : std::string(1, separator)) + name;
    const bool number = name.size() <= kMaxNumberLength && Rational::parse(name);
    if (number || parse_iso_time(name, problem)) ++values;
  }
  if (2 * values < names.size()) return;
  throw InputError(file, "line 1", show_text(line) + ": values, not names of columns",
                   "write a line above it that names the columns, as id,t,x,y");
}

CsvTable parse_csv(std::string_view text, const std::string& file, char separator) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.substr(0, 3) == kByteOrderMark) text.remove_prefix(3);
  if (text.find('\r') != text.npos && text.find('\n') == text.npos) {
    throw InputError(file, "", "its lines end with carriage returns (CR) alone",
                     "end them with line feeds: tr '\\r' '\\n' < FILE");
  }
  CsvTable table;
  table.separator = separator == kGuessedSeparator ? separator_of(text) : separator;
  CsvParser parser(text, file, table.separator);
  CsvRow row;
  if (!parser.next(row))
    throw InputError(file, "", "the file is empty", "name the columns in line 1");
  for (const std::string& field : row.fields) {
    std::string name = trimmed(field);
    if (!is_utf8(name)) {
      throw InputError(file, "line " + std::to_string(row.line),
                       "column " + show_text(name) + " is not UTF-8", "convert the file to UTF-8");
    }
    if (table.column(name)) {
      check_names(row.fields, table.separator, file);
      throw InputError(file, "line " + std::to_string(row.line),
                       "column " + show_text(name) + " stands twice", "remove one");
    }
    table.columns.push_back(std::move(name));
  }
  while (parser.next(row)) {
    if (row.fields.size() != table.columns.size()) {
      throw InputError(file, "line " + std::to_string(row.line),
                       counted(row.fields.size(), "field", "fields") + " in a table of " +
                           counted(table.columns.size(), "column", "columns") + ": " +
                           show_text(parser.row_text()),
                       remedy_for_fields(row, parser.row_text(), table));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> parse_csv_row(std::string_view text, const std::string& source) {
  CsvParser parser(text, source, ',');
  CsvRow row{1, {}}, other;
  if (!parser.next(row)) row.fields.assign(1, "");
  if (parser.next(other)) {
    throw InputError(source, "", "a second line: " + show_text(other.fields[0]), "write one row");
  }
  return std::move(row.fields);
}

}  // namespace kinex::formats
