// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/formats/log_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/formats/json_writer.h"

namespace kinex::formats {

namespace {

constexpr std::size_t kLongestExact = 40;
constexpr std::size_t kPlainColumns = 8;
using PlainRow = std::array<std::string, kPlainColumns>;

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
    if (id.empty() || id.find_first_of(" \"\\\t\r\n") != std::string::npos) {
      append_json_string(text, id);
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

PlainRow plain_row(const LogRecord& record, const LogHeader& header) {
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
          record.structure,
          record.kind,
          std::move(ids),
          record.external ? "external" : "internal",
          std::move(certificate)};
}

std::string aligned(const std::vector<PlainRow>& rows) {
  std::array<std::size_t, kPlainColumns> widths{};
  for (const PlainRow& row : rows) {
    for (std::size_t i = 0; i < kPlainColumns; ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const PlainRow& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < kPlainColumns; ++i) {
      if (widths[i] == 0) continue;  // a log without times
      if (!line.empty()) line += "  ";
      const std::string space(widths[i] - row[i].size(), ' ');
      line += i == 0 ? space + row[i] : row[i] + space;
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
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

LogTable log_table(LogReader& reader, const LogFilter& filter, LogTableForm form) {
  const LogHeader& header = reader.header();
  LogTable table;
  std::vector<PlainRow> rows;
  if (form == LogTableForm::kCsv) {
    append_csv_row(table.text, csv_columns());
  } else {
    rows.push_back({"seq", header.has_times() ? "time" : "", header.has_names() ? "exactly" : "",
                    "structure", "kind", "ids", "effect", "certificate"});
  }
  LogRecord record;
  while (reader.next(record)) {
    ++table.records;
    if (!filter.wants(record)) continue;
    ++table.shown;
    if (form == LogTableForm::kCsv) {
      append_csv_row(table.text, csv_row(record, header));
    } else {
      rows.push_back(plain_row(record, header));
    }
  }
  table.complete = reader.end().has_value();
  if (form == LogTableForm::kPlain) table.text = aligned(rows);
  return table;
}

}  // namespace kinex::formats
