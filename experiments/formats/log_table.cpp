// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_table.h"

#include <algorithm>
#include <utility>

#include "core/numbers/near_names.h"
#include "experiments/formats/input_error.h"
#include "experiments/formats/json_writer.h"
#include "experiments/formats/plain_text.h"

namespace kinex::formats {

namespace {

constexpr std::size_t kLongestExact = 40;

// "4 - 6 t + t^2"
std::string polynomial_words(const Polynomial& polynomial) {
  std::string text;
  for (std::size_t k = 0; k < polynomial.coefficients().size(); ++k) {
    const Integer& c = polynomial.coefficients()[k];
    if (c.is_zero()) continue;
    std::string digits = c.to_string();
    const bool negative = digits[0] == '-';
    if (negative) digits.erase(0, 1);
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    const std::string power = k == 0 ? "" : k == 1 ? "t" : "t^" + std::to_string(k);
    const bool unit = digits == "1" && k > 0;
    text += unit ? power : digits + (power.empty() ? "" : " " + power);
  }
  return text;
}

std::string ids_text(const std::vector<std::string>& ids) {
  std::string text;
  for (const std::string& id : ids) {
    if (!text.empty()) text += ' ';
    if (id.empty() || id.find_first_of(" \"\\") != std::string::npos || plain(id) != id) {
      std::string quoted;
      append_json_string(quoted, id);
      text += plain(quoted);
    } else {
      text += id;
    }
  }
  return text;
}

void append_field(std::string& line, const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) {
    line += field;
    return;
  }
  line += '"';
  for (const char c : field) {
    if (c == '"') line += '"';
    line += c;
  }
  line += '"';
}

void append_csv_row(std::string& text, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) text += ',';
    append_field(text, fields[i]);
  }
  text += '\n';
}

const std::vector<std::string>& csv_columns() {
  static const std::vector<std::string> kColumns{
      "seq",       "time", "polynomial", "root",     "lower",     "upper",
      "structure", "kind", "ids",        "external", "predicate", "certificate_ids",
      "gone",      "came", "reason"};
  return kColumns;
}

constexpr std::size_t kSequence = 0, kTime = 1, kExactly = 2;

const LogRow& plain_columns() {
  static const LogRow kColumns{"seq",  "time", "exactly", "structure",
                               "kind", "ids",  "effect",  "certificate"};
  return kColumns;
}

// All places if none is named.
std::vector<std::size_t> places_of(const std::vector<std::string>& wanted,
                                   const std::vector<std::string>& columns) {
  std::vector<std::size_t> places;
  for (const std::string& name : wanted) {
    const auto at = std::find(columns.begin(), columns.end(), name);
    if (at == columns.end()) {
      std::string all;
      for (const std::string& one : columns) all += (all.empty() ? "write some of " : ", ") + one;
      throw InputError("--columns", "", show_text(name) + " is not a column of the table",
                       did_you_mean(name, columns, all));
    }
    places.push_back(static_cast<std::size_t>(at - columns.begin()));
  }
  for (std::size_t i = 0; wanted.empty() && i < columns.size(); ++i) places.push_back(i);
  return places;
}

std::vector<std::string> chosen(const std::vector<std::string>& fields,
                                const std::vector<std::size_t>& places) {
  std::vector<std::string> result;
  for (const std::size_t place : places) result.push_back(fields[place]);
  return result;
}

std::vector<std::string> csv_row(const LogRecord& record, const LogHeader& header) {
  std::string polynomial, root, lower, upper;
  if (header.has_names()) {
    for (const Integer& c : record.time.polynomial.coefficients()) {
      polynomial += (polynomial.empty() ? "" : " ") + c.to_string();
    }
    root = std::to_string(record.time.root);
  }
  if (header.has_intervals()) {
    lower = record.time.lower.to_string();
    upper = record.time.upper.to_string();
  }
  const bool certified = record.certificate.has_value(), changed = record.change.has_value();
  return {std::to_string(record.sequence),
          header.has_times() ? record.time.decimal : "",
          polynomial,
          root,
          lower,
          upper,
          record.structure,
          record.kind,
          ids_text(record.ids),
          record.external ? "true" : "false",
          certified ? record.certificate->predicate : "",
          certified ? ids_text(record.certificate->ids) : "",
          changed ? ids_text(record.change->gone) : "",
          changed ? ids_text(record.change->came) : "",
          record.reason.value_or("")};
}

}  // namespace

std::string instant_words(const LogInstant& instant, const LogHeader& header) {
  if (!header.has_names()) return "";
  if (instant.lower == instant.upper) {
    std::string exact = instant.lower.to_string();
    if (exact.size() <= kLongestExact) return exact;
    return "a fraction of " + std::to_string(exact.size() - 1) + " digits";
  }
  const std::string root = "root " + std::to_string(instant.root) + " of ";
  const std::string words = polynomial_words(instant.polynomial);
  if (words.size() <= kLongestExact) return root + words;
  return root + "a polynomial of degree " +
         std::to_string(instant.polynomial.coefficients().size() - 1);
}

LogRow log_row(const LogRecord& record, const LogHeader& header) {
  std::string certificate;
  if (record.certificate)
    certificate = record.certificate->predicate + "(" + ids_text(record.certificate->ids) + ")";
  std::string ids = ids_text(record.ids);
  if (record.change) {
    if (!ids.empty()) ids += ' ';
    ids += "-[" + ids_text(record.change->gone) + "] +[" + ids_text(record.change->came) + "]";
  }
  return {std::to_string(record.sequence),
          header.has_times() ? record.time.decimal : "",
          instant_words(record.time, header),
          plain(record.structure),
          record.kind,
          std::move(ids),
          record.external ? "external" : "internal",
          std::move(certificate)};
}

std::vector<std::string> aligned_rows(const std::vector<LogRow>& rows, std::size_t numbers) {
  std::vector<std::size_t> widths;
  for (const LogRow& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::vector<std::string> lines;
  for (const LogRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (widths[i] == 0) continue;  // a log without times
      if (!line.empty()) line += "  ";
      const std::string space(widths[i] - row[i].size(), ' ');
      line += i == numbers ? space + row[i] : row[i] + space;
    }
    lines.push_back(line.substr(0, line.find_last_not_of(' ') + 1));
  }
  return lines;
}

LogTable log_table(LogReader& reader, const LogFilter& filter, LogTableForm form,
                   const std::vector<std::string>& columns) {
  const LogHeader& header = reader.header();
  const bool csv = form == LogTableForm::kCsv;
  const std::vector<std::size_t> places =
      places_of(columns, csv ? csv_columns() : plain_columns());
  const std::set<std::string> only_read = labels_only_read(header);
  LogTable table;
  std::vector<LogRow> rows;
  if (csv) {
    append_csv_row(table.text, chosen(csv_columns(), places));
  } else {
    LogRow head = plain_columns();
    if (!header.has_times()) head[kTime].clear();
    if (!header.has_names()) head[kExactly].clear();
    rows.push_back(chosen(head, places));
  }
  LogRecord record;
  while (reader.next(record)) {
    ++table.records;
    if (record.external)
      ++(only_read.contains(record.structure) ? table.external.read : table.external.maintained);
    if (!filter.wants(record)) continue;
    ++table.shown;
    if (csv) {
      append_csv_row(table.text, chosen(csv_row(record, header), places));
    } else {
      rows.push_back(chosen(log_row(record, header), places));
    }
  }
  table.complete = reader.end().has_value();
  const auto numbers = std::find(places.begin(), places.end(), kSequence) - places.begin();
  for (const std::string& line : aligned_rows(rows, static_cast<std::size_t>(numbers)))
    table.text += line + "\n";
  return table;
}

}  // namespace kinex::formats
